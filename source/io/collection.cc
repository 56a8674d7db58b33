#include <heddle/base/file.h>
#include <heddle/io/collection.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace Heddle
{
  namespace IO
  {
    Collection::Collection(const std::string &directory,
                           const std::string &name,
                           const MPI_Comm     communicator,
                           const unsigned int resume_at)
      : directory(directory)
      , name(name)
      , first_rank(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      if (!first_rank || resume_at == 0)
        return;

      const std::string before_number = name + "/" + name + "-";
      std::ifstream     file(directory + "/" + name + ".pvd");
      for (std::string line; std::getline(file, line);)
        {
          const auto begin = line.rfind(before_number);
          if (begin != std::string::npos &&
              std::strtoul(&line[begin + before_number.size()], nullptr, 10) <
                resume_at)
            entries.push_back(line);
        }
      file.close();
      write_list();
    }



    void
    Collection::remove(const std::string &directory, const std::string &name)
    {
      namespace files = std::filesystem;
      files::remove(directory + "/" + name + ".pvd");
      std::vector<files::path> old;
      const std::string        folder = directory + "/" + name;
      if (files::is_directory(folder))
        for (const auto &entry : files::directory_iterator(folder))
          if (entry.path().extension() == ".vtu" &&
              entry.path().stem().string().rfind(name + "-", 0) == 0)
            old.push_back(entry.path());
      for (const files::path &file : old)
        files::remove(file);
    }



    std::string
    Collection::file_name(const unsigned int number) const
    {
      return name + "/" + name + "-" +
             dealii::Utilities::int_to_string(number, 5) + ".vtu";
    }



    std::string
    Collection::path(const unsigned int number) const
    {
      return directory + "/" + file_name(number);
    }



    void
    Collection::add(const unsigned int number,
                    const double       time,
                    const std::string &stage)
    {
      if (!first_rank)
        return;

      std::ostringstream entry;
      entry.precision(12);
      entry << "    <DataSet timestep=\"" << time << "\" group=\"" << stage
            << "\" part=\"0\" file=\"" << file_name(number) << "\"/>";
      entries.push_back(entry.str());
      write_list();
    }



    void
    Collection::write_list() const
    {
      std::string list = "<?xml version=\"1.0\"?>\n"
                         "<VTKFile type=\"Collection\" version=\"0.1\" "
                         "byte_order=\"LittleEndian\">\n  <Collection>\n";
      for (const auto &line : entries)
        list += line + "\n";
      list += "  </Collection>\n</VTKFile>\n";
      write_file(directory + "/" + name + ".pvd", list);
    }
  } // namespace IO
} // namespace Heddle
