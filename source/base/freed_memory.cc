#include <heddle/base/freed_memory.h>

#include <cstdlib>

// Others than GNU's library do so by themselves, or not at all.
#ifdef __GLIBC__
#  include <malloc.h>
#endif

namespace Heddle
{
  void
  return_freed_memory()
  {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  }
} // namespace Heddle
