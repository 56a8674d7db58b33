#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/throw_together.h>

#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace Heddle
{
  using namespace dealii;

  std::string
  read_file(const std::string &name, const std::string &what)
  {
    std::error_code error;
    const auto      status = std::filesystem::status(name, error);
    require(std::filesystem::exists(status),
            "There is no " + what + " \"" + name + "\".");
    require(!std::filesystem::is_directory(status),
            "The " + what + " \"" + name + "\" is a folder.");

    std::ifstream in(name, std::ios::binary);
    require(in.good(), "The " + what + " \"" + name + "\" cannot be read.");
    std::string text{std::istreambuf_iterator<char>(in),
                     std::istreambuf_iterator<char>()};

    // Spreadsheets mark their text as UTF-8 by three bytes.
    if (text.rfind("\xEF\xBB\xBF", 0) == 0)
      text.erase(0, 3);
    return text;
  }



  std::string
  read_file(const std::string &name,
            const std::string &what,
            const MPI_Comm     communicator)
  {
    // Whoever reads before MPI starts is alone.
    if (!Utilities::MPI::job_supports_mpi())
      return read_file(name, what);

    return ask_first_rank([&]() { return read_file(name, what); },
                          communicator);
  }



  void
  write_file(const std::string &name, const std::string &text)
  {
    const std::string beside = name + ".new";
    {
      std::ofstream out(beside, std::ios::binary);
      out << text << std::flush;
      if (!out.good())
        {
          std::error_code nobody_is_left_to_tell;
          std::filesystem::remove(beside, nobody_is_left_to_tell);
          throw std::runtime_error("The file \"" + beside +
                                   "\" cannot be written: is there space on "
                                   "the disk?");
        }
    }
    std::filesystem::rename(beside, name);
  }



  void
  create_folder(const std::string &name)
  {
    std::error_code error;
    std::filesystem::create_directories(name, error);
    require(std::filesystem::is_directory(name, error),
            "The folder \"" + name + "\" cannot be created.");
    require(access(name.c_str(), W_OK | X_OK) == 0,
            "The folder \"" + name + "\" cannot be written to.");
  }



  std::string
  relative_to(const std::string &from, const std::string &name)
  {
    const std::filesystem::path folder =
      std::filesystem::path(from).parent_path();
    return (folder / name).lexically_normal().string();
  }
} // namespace Heddle
