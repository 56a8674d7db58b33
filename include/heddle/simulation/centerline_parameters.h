#ifndef heddle_simulation_centerline_parameters_h
#define heddle_simulation_centerline_parameters_h

#include <heddle/textile/path_reader.h>

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /** Fibers from a file of centerlines. */
    class CenterlineParameters : public ParameterAcceptor
    {
    public:
      CenterlineParameters(const std::string &section = "/Centerlines");

      /** How the file is read, for an element of so many nodes. */
      Textile::PathReading
      reading(const unsigned int nodes_per_element) const;

      std::string file;
      bool        straight_when_free = false;

    private:
      Textile::PathReading entries;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
