#ifndef heddle_contributions_fiber_matrix_coupling_h
#define heddle_contributions_fiber_matrix_coupling_h

#include <heddle/coupling/link.h>
#include <heddle/coupling/section_link.h>
#include <heddle/system/contribution.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /** A particle of a fiber that was found in a cell of the matrix. */
    struct EmbeddedPoint
    {
      unsigned int fiber;

      /** Its place follows from these blocks of the fiber. */
      System::MaterialPoint particle;

      unsigned int        cell;
      std::vector<double> shapes; /**< of the nodes of the cell there [-] */
      double              length; /**< of the fiber that it stands for [mm] */

      /** Its section, and the gradients of the shapes [1/mm], if it is held. */
      System::SectionPoint      section   = {};
      std::vector<Tensor<1, 3>> gradients = {};

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &fiber &particle.blocks &particle.values &cell &shapes &length;
        archive &section.blocks &section.values &gradients;
      }
    };

    /**
     * Elastic links between particles of fibers and those of the matrix at the
     * same place: coupling elements (Durville, 2007). Their stiffness is
     * constant, that of the matrix times the length of fiber that a link stands
     * for, so that the force per length does not depend on the mesh of the
     * fiber.
     *
     * Points with a section link that, too: the matrix grips the surface of a
     * fiber of radius R, so that a link of stiffness k resists its turning
     * about its axis by @f$ k R^2 @f$ (Coupling::SectionLink).
     */
    class FiberMatrixCoupling : public System::Contribution
    {
    public:
      /** For output: where a link is, and its force on the fiber. */
      struct Point
      {
        unsigned int fiber;
        Tensor<1, 3> position; /**< [mm] */
        Tensor<1, 3> force;    /**< [N] */
        double       length;   /**< of fiber [mm] */
      };

      /**
       * Links have no force in the configuration of @p state, which holds all
       * blocks of the @p points. @p stiffness is per length of fiber [MPa].
       */
      FiberMatrixCoupling(const System::MatrixSpace        &matrix,
                          const System::State              &state,
                          const std::vector<EmbeddedPoint> &points,
                          const double                      stiffness);

      std::string
      name() const override
      {
        return "fiber-matrix coupling";
      }

      void
      add_pattern(const System::State  &state,
                  System::BlockPattern &pattern) override;

      void
      assemble(const System::State &state,
               System::BlockSystem &system) override;

      void
      raise_stiffness(System::NodeStiffness &stiffness) const override;

      void
      report(const System::State           &state,
             std::map<std::string, double> &values) const override;

      /** The links of the owned fibers. */
      std::vector<Point>
      points(const System::State &state) const;

    private:
      struct EmbeddedLink
      {
        unsigned int                 fiber;
        double                       length;
        std::array<unsigned int, 4>  fiber_blocks;
        std::array<unsigned int, 27> matrix_blocks;
        Coupling::Link               link;
      };

      struct EmbeddedSection
      {
        unsigned int                 fiber;
        std::array<unsigned int, 4>  fiber_blocks;
        std::array<unsigned int, 27> matrix_blocks;
        Coupling::SectionLink        link;
      };

      /** Local blocks of a link, and their places, for the kernel. */
      struct Places
      {
        std::array<unsigned int, Coupling::max_weights> blocks;
        std::array<Tensor<1, 3>, Coupling::max_weights> places;
      };

      void
      add_section(const EmbeddedPoint       &point,
                  const double               stiffness,
                  const System::MatrixSpace &matrix,
                  const System::State       &state);

      /** Those of the fiber come first. */
      template <class Embedded>
      static void
      find_places(const Embedded      &embedded,
                  const System::State &state,
                  Places              &places);

      template <class Embedded>
      static void
      assemble_links(const std::vector<Embedded> &links,
                     const System::State         &state,
                     System::BlockSystem         &system);

      std::vector<EmbeddedLink>    links;
      std::vector<EmbeddedSection> sections;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
