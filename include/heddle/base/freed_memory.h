#ifndef heddle_base_freed_memory_h
#define heddle_base_freed_memory_h

namespace Heddle
{
  /**
   * Give memory that was freed back to the system. Between pieces that are in
   * use what was freed is of use only to what is no larger: after a search for
   * an equilibrium, not to the copies of all contacts that output makes.
   */
  void
  return_freed_memory();
} // namespace Heddle

#endif
