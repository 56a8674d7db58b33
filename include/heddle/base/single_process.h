#ifndef heddle_base_single_process_h
#define heddle_base_single_process_h

namespace Heddle
{
  /**
   * Whether this process was started by itself: no mpirun, srun or the like
   * left in the environment which of several ranks it is.
   */
  bool
  is_single_process();

  /**
   * Spare a process that is_single_process() the daemon and the networks that
   * Open MPI otherwise starts and looks for, a quarter of a second. Settings in
   * the environment (OMPI_MCA_...) take precedence, and ranks of a launcher are
   * left as they are.
   *
   * @note To be called before MPI is initialized. Such a process must not open
   * files by MPI: there is no folder for what Open MPI writes down of them.
   */
  void
  spare_daemon_and_networks();
} // namespace Heddle

#endif
