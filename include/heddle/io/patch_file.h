#ifndef heddle_io_patch_file_h
#define heddle_io_patch_file_h

#include <deal.II/base/data_out_base.h>

#include <mpi.h>

#include <string>
#include <tuple>
#include <vector>

namespace Heddle
{
  namespace IO
  {
    using namespace dealii;

    /**
     * Hand-made patches (points: 0, lines: 1, rectangles: 2, hexahedra: 3) and
     * the names of the data on them, to be written as one VTU file by all ranks
     * together.
     */
    template <int patch_dim>
    class PatchFile : public DataOutInterface<patch_dim, 3>
    {
    public:
      using Patch = DataOutBase::Patch<patch_dim, 3>;

      /** A name ending in "[3]" stands for the three components of a vector. */
      PatchFile(const std::vector<std::string> &fields);

      /** Number of numbers at each point. */
      unsigned int
      n_components() const
      {
        return component_names.size();
      }

      /**
       * Write beside @p path and rename; its folder is made.
       * @note Collective.
       */
      void
      write(const std::string &path, const MPI_Comm communicator);

      std::vector<Patch> patches;

    protected:
      const std::vector<Patch> &
      get_patches() const override
      {
        return patches;
      }

      std::vector<std::string>
      get_dataset_names() const override
      {
        return component_names;
      }

      std::vector<
        std::tuple<unsigned int,
                   unsigned int,
                   std::string,
                   DataComponentInterpretation::DataComponentInterpretation>>
      get_nonscalar_data_ranges() const override
      {
        return vectors;
      }

    private:
      /** A file of no patches, with the names of the data. */
      std::string
      without_points() const;

      std::vector<std::string> component_names;
      std::vector<
        std::tuple<unsigned int,
                   unsigned int,
                   std::string,
                   DataComponentInterpretation::DataComponentInterpretation>>
        vectors;
    };
  } // namespace IO
} // namespace Heddle

#endif
