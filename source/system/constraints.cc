#include <heddle/system/constraints.h>

namespace Heddle
{
  namespace System
  {
    void
    Constraints::set(const std::vector<Constraint> &new_constraints,
                     const unsigned int             n_blocks)
    {
      constraints = new_constraints;
      constraint_of_block.assign(n_blocks, -1);
      for (unsigned int c = 0; c < constraints.size(); ++c)
        constraint_of_block[constraints[c].block] = c;
    }



    Tensor<1, 3>
    Constraints::motion(const unsigned int block) const
    {
      const Constraint &constraint = of(block);
      Tensor<1, 3>      motion;
      for (unsigned int d = 0; d < 3; ++d)
        if (constraint.fixed[d])
          motion += constraint.pending[d] * constraint.frame[d];
      return motion;
    }



    Tensor<2, 3>
    Constraints::turned_and_cleared(const unsigned int row,
                                    const unsigned int column,
                                    Tensor<2, 3>       value) const
    {
      if (is_constrained(row))
        {
          const Constraint &constraint = of(row);
          value                        = constraint.frame * value;
          for (unsigned int d = 0; d < 3; ++d)
            if (constraint.fixed[d])
              value[d] = 0.;
        }
      if (is_constrained(column))
        {
          const Constraint &constraint = of(column);
          value                        = value * transpose(constraint.frame);
          for (unsigned int d = 0; d < 3; ++d)
            if (constraint.fixed[d])
              for (unsigned int e = 0; e < 3; ++e)
                value[e][d] = 0.;
        }
      return value;
    }



    void
    Constraints::turn_into_frames(const unsigned int  n,
                                  const unsigned int *blocks,
                                  double             *tangent) const
    {
      const unsigned int size = 3 * n;
      for (unsigned int i = 0; i < n; ++i)
        if (is_constrained(blocks[i]))
          {
            const Tensor<2, 3> &frame = of(blocks[i]).frame;
            for (unsigned int j = 0; j < size; ++j)
              {
                Tensor<1, 3> column;
                for (unsigned int d = 0; d < 3; ++d)
                  column[d] = tangent[j * size + 3 * i + d];
                column = frame * column;
                for (unsigned int d = 0; d < 3; ++d)
                  tangent[j * size + 3 * i + d] = column[d];
              }
            for (unsigned int j = 0; j < size; ++j)
              {
                Tensor<1, 3> row;
                for (unsigned int d = 0; d < 3; ++d)
                  row[d] = tangent[(3 * i + d) * size + j];
                row = frame * row;
                for (unsigned int d = 0; d < 3; ++d)
                  tangent[(3 * i + d) * size + j] = row[d];
              }
          }
    }



    void
    Constraints::eliminate(const unsigned int         n,
                           const unsigned int        *blocks,
                           double                    *tangent,
                           std::vector<Tensor<1, 3>> &lifting) const
    {
      turn_into_frames(n, blocks, tangent);
      const unsigned int size = 3 * n;
      for (unsigned int column = 0; column < size; ++column)
        if (is_fixed(blocks[column / 3], column % 3))
          {
            const double pending = of(blocks[column / 3]).pending[column % 3];
            for (unsigned int j = 0; j < size; ++j)
              {
                if (blocks[j / 3] < lifting.size())
                  lifting[blocks[j / 3]][j % 3] +=
                    tangent[j * size + column] * pending;
                tangent[j * size + column] = 0.;
                tangent[column * size + j] = 0.;
              }
          }
    }



    template <typename Action>
    void
    Constraints::for_each_of(std::vector<Tensor<1, 3>> &values,
                             const Action              &action) const
    {
      for (const Constraint &constraint : constraints)
        if (constraint.block < values.size())
          action(constraint, values[constraint.block]);
    }



    void
    Constraints::turn_into_frames(std::vector<Tensor<1, 3>> &values) const
    {
      for_each_of(values,
                  [](const Constraint &constraint, Tensor<1, 3> &value) {
                    value = constraint.frame * value;
                  });
    }



    void
    Constraints::turn_out_of_frames(std::vector<Tensor<1, 3>> &values) const
    {
      for_each_of(values,
                  [](const Constraint &constraint, Tensor<1, 3> &value) {
                    value = transpose(constraint.frame) * value;
                  });
    }



    void
    Constraints::clear_fixed(std::vector<Tensor<1, 3>> &values) const
    {
      for_each_of(values,
                  [](const Constraint &constraint, Tensor<1, 3> &value) {
                    for (unsigned int d = 0; d < 3; ++d)
                      if (constraint.fixed[d])
                        value[d] = 0.;
                  });
    }



    void
    Constraints::set_pending(std::vector<Tensor<1, 3>> &values) const
    {
      for_each_of(values,
                  [](const Constraint &constraint, Tensor<1, 3> &value) {
                    for (unsigned int d = 0; d < 3; ++d)
                      if (constraint.fixed[d])
                        value[d] = constraint.pending[d];
                  });
    }



    void
    Constraints::add_motion(std::vector<Tensor<1, 3>> &values) const
    {
      for_each_of(values,
                  [this](const Constraint &constraint, Tensor<1, 3> &value) {
                    value += motion(constraint.block);
                  });
    }
  } // namespace System
} // namespace Heddle
