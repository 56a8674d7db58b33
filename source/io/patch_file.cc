#include <heddle/base/file.h>
#include <heddle/base/throw_together.h>
#include <heddle/io/patch_file.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
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
    std::string
    PatchFile<patch_dim>::without_points() const
    {
      const auto array = [](const std::string &type, const std::string &more) {
        return "<DataArray type=\"" + type + "\" " + more +
               " format=\"ascii\"/>\n";
      };
      const std::string three = " NumberOfComponents=\"3\"";
      std::string       data;
      for (unsigned int i = 0; i < component_names.size(); ++i)
        {
          const bool is_vector =
            std::any_of(vectors.begin(), vectors.end(), [i](const auto &range) {
              return std::get<0>(range) == i;
            });
          data += array("Float32",
                        "Name=\"" + component_names[i] + "\"" +
                          (is_vector ? three : ""));
          i += is_vector ? 2 : 0;
        }
      return "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
             "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
             "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\">\n<Points>\n" +
             array("Float32", three) + "</Points>\n<Cells>\n" +
             array("Int32", "Name=\"connectivity\"") +
             array("Int32", "Name=\"offsets\"") +
             array("UInt8", "Name=\"types\"") + "</Cells>\n<PointData>\n" +
             data + "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
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
      const bool mine      = !patches.empty();
      const auto n_writers = Utilities::MPI::sum(mine ? 1 : 0, communicator);
      if (n_writers == 0)
        write_together([&]() { write_file(beside, without_points()); },
                       communicator);
      // One rank needs no MPI to write a file.
      else if (Utilities::MPI::n_mpi_processes(communicator) == 1)
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
        {
          // Of a rank that has nothing deal.II writes a piece that readers do
          // not take for the first one.
          MPI_Comm writers;
          MPI_Comm_split(communicator,
                         mine ? 0 : MPI_UNDEFINED,
                         Utilities::MPI::this_mpi_process(communicator),
                         &writers);
          if (mine)
            {
              this->write_vtu_in_parallel(beside, writers);
              MPI_Comm_free(&writers);
            }
        }
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
