#ifndef heddle_contributions_nodal_springs_h
#define heddle_contributions_nodal_springs_h

#include <heddle/system/contribution.h>

#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Springs from nodes to points in space, with a constant force beside:
     * what guides the ends of yarns across and draws them along.
     */
    class NodalSprings : public System::Contribution
    {
    public:
      struct Spring
      {
        unsigned int fiber;
        unsigned int node;
        Tensor<1, 3> target;    /**< [mm] */
        Tensor<2, 3> stiffness; /**< symmetric [N/mm] */
        Tensor<1, 3> force;     /**< [N] */
      };

      /** @p name is what the log and the summary call them; @p springs are
       * those of all ranks. */
      NodalSprings(const std::string &name, const std::vector<Spring> &springs);

      std::string
      name() const override
      {
        return own_name;
      }

      void
      assemble(const System::State &state,
               System::BlockSystem &system) override;

      double
      tension() const override
      {
        return largest_force;
      }

    private:
      const std::string         own_name;
      const std::vector<Spring> springs;
      double                    largest_force = 0.; /**< [N] */
    };
  } // namespace Contributions
} // namespace Heddle

#endif
