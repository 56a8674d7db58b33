#include <heddle/base/file.h>

#include <deal.II/base/exceptions.h>

#include <filesystem>
#include <fstream>

namespace Heddle
{
  void
  write_file(const std::string &path, const std::string &content)
  {
    const auto folder = std::filesystem::path(path).parent_path();
    if (!folder.empty())
      std::filesystem::create_directories(folder);

    const std::string beside = path + ".part";
    {
      std::ofstream file(beside, std::ios::binary);
      file << content << std::flush;
      AssertThrow(file,
                  dealii::ExcMessage("Cannot write the file '" + beside +
                                     "': is the folder writable, and is there "
                                     "space on the disk?"));
    }
    std::filesystem::rename(beside, path);
  }
} // namespace Heddle
