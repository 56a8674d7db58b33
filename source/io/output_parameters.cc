#include <heddle/io/output_parameters.h>

namespace Heddle
{
  namespace IO
  {
    OutputParameters::OutputParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_parameter("Interval",
                    interval,
                    "Write fibers, contacts, plates and matrix every so many "
                    "load steps, and "
                    "after the last step of each stage; 0: never, and nothing "
                    "is computed for it [steps].",
                    prm,
                    Patterns::Integer(0));
      add_parameter("Fibers",
                    fibers,
                    "Whether to write the fibers, with their strains and "
                    "section forces, as lines (fibers.pvd), and with them the "
                    "plates, if there are any (plates.pvd) [-].");
      add_parameter("Subdivisions",
                    subdivisions,
                    "Straight pieces by which the smooth centerline of one "
                    "element is drawn; inactive without 'Fibers' [-].",
                    prm,
                    Patterns::Integer(1, 100));
      add_parameter("Contacts",
                    contacts,
                    "Whether to write the contact elements, with gap, normal "
                    "and force, as points (contacts.pvd) [-].");
      add_parameter("Matrix",
                    matrix,
                    "Whether to write the matrix, with displacement, strain "
                    "and stress (matrix.pvd), and its links to the fibers, "
                    "with their forces, as points (coupling.pvd). Inactive "
                    "without a matrix [-].");
      add_parameter("Centerlines",
                    centerlines,
                    "Whether to write where the nodes of the fibers are at the "
                    "end of a stage, as a table that 'Centerlines/File' takes "
                    "(centerlines.csv); inactive if 'Interval' is 0 [-].");
      add_parameter("Checkpoint interval",
                    checkpoint_interval,
                    "Save the state, for --resume, every so many load steps, "
                    "and after the last step of each stage; 0: only where a "
                    "run is stopped or finds no equilibrium, which saves its "
                    "last state in any case [steps].",
                    prm,
                    Patterns::Integer(0));
      add_parameter("Checkpoints kept",
                    n_checkpoints,
                    "How many of the last checkpoints stay on the disk; "
                    "inactive if 'Checkpoint interval' is 0 [-].",
                    prm,
                    Patterns::Integer(1));
      add_parameter("Yarn stations",
                    yarn_stations,
                    "Sections at which each yarn is measured at the end of a "
                    "stage (yarns.csv) and, in the mean, in each step "
                    "(history.csv); 0: none, nor what else is measured on them "
                    "(crossings.csv, orientation.csv, results of summary.json, "
                    "thickness and crimp in history.csv). Inactive without "
                    "yarns [-].",
                    prm,
                    Patterns::Integer(0));
    }



    bool
    OutputParameters::due(const unsigned int step,
                          const bool         last_of_stage) const
    {
      return interval > 0 &&
             (last_of_stage || (step > 0 && step % interval == 0));
    }



    bool
    OutputParameters::checkpoint_due(const unsigned int step,
                                     const bool         last_of_stage) const
    {
      return checkpoint_interval > 0 &&
             (last_of_stage || step % checkpoint_interval == 0);
    }
  } // namespace IO
} // namespace Heddle
