#include <heddle/base/file.h>
#include <heddle/base/throw_together.h>
#include <heddle/io/patch_file.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>

namespace Heddle
{
  namespace IO
  {
    template <int patch_dim>
    PatchFile<patch_dim>::PatchFile(const std::vector<std::string> &fields)
    {
      const std::string suffix = "[3]";
      for (const auto &field : fields)
        {
          const auto end = field.find(suffix);
          if (end == std::string::npos)
            component_names.push_back(field);
          else
            {
              const std::string  name  = field.substr(0, end);
              const unsigned int first = component_names.size();
              component_names.insert(component_names.end(), 3, name);
              vectors.emplace_back(
                first,
                first + 2,
                name,
                DataComponentInterpretation::component_is_part_of_vector);
            }
        }

      // Dates would make every file differ from the last run's.
      this->set_flags(DataOutBase::VtkFlags(
        /*time=*/std::numeric_limits<double>::min(),
        /*cycle=*/std::numeric_limits<unsigned int>::min(),
        /*print_date_and_time=*/false,
        DataOutBase::VtkFlags::best_speed));
    }



    template <int patch_dim>
    void
    PatchFile<patch_dim>::write(const std::string &path,
                                const MPI_Comm     communicator)
    {
      const std::filesystem::path folder =
        std::filesystem::path(path).parent_path();
      const std::string beside = path + ".part";

      write_together([&]() { create_folder(folder.string()); }, communicator);
      // One rank needs no MPI to write a file.
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        {
          std::ofstream out(beside, std::ios::binary);
          this->write_vtu(out);
          out.flush();
          AssertThrow(out.good(),
                      ExcMessage("The file \"" + beside +
                                 "\" cannot be written: is there space on "
                                 "the disk?"));
        }
      else
        this->write_vtu_in_parallel(beside, communicator);
      MPI_Barrier(communicator);
      // No rank goes on before the file is there under its name.
      write_together([&]() { std::filesystem::rename(beside, path); },
                     communicator);
    }



    template class PatchFile<0>;
    template class PatchFile<1>;
    template class PatchFile<2>;
    template class PatchFile<3>;
  } // namespace IO
} // namespace Heddle
