#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/throw_together.h>
#include <heddle/io/checkpoint.h>
#include <heddle/io/hdf5_archive.h>
#include <heddle/system/block_archive.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

namespace Heddle
{
  namespace IO
  {
    using namespace dealii;

    namespace internal
    {
      namespace Checkpoint
      {
        /** All complete checkpoints of a folder, in ascending order. */
        std::vector<std::filesystem::path>
        files(const std::string &folder)
        {
          std::vector<std::filesystem::path> paths;
          std::error_code                    none_there, unreadable;
          if (std::filesystem::is_directory(folder, none_there))
            for (const auto &entry :
                 std::filesystem::directory_iterator(folder, unreadable))
              if (entry.path().extension() == ".h5" &&
                  entry.path().stem().string().rfind("step-", 0) == 0)
                paths.push_back(entry.path());
          require(!unreadable, "The folder \"" + folder + "\" cannot be read.");
          // From 100000 on numbers have more digits.
          std::sort(
            paths.begin(), paths.end(), [](const auto &a, const auto &b) {
              const auto length = [](const std::filesystem::path &path) {
                return path.native().size();
              };
              return std::make_pair(length(a), a) <
                     std::make_pair(length(b), b);
            });
          return paths;
        }



        std::string
        folder(const std::string &directory)
        {
          return directory + "/checkpoint";
        }



        std::string
        last_file(const std::string &directory)
        {
          const auto paths = files(folder(directory));
          require(!paths.empty(),
                  "There is no checkpoint in \"" + directory +
                    "\" to resume from: run without --resume first.");
          return paths.back().string();
        }



        /** What a fiber must agree in: length, radius, numbers of its parts. */
        std::vector<double>
        identity(const System::Fiber &fiber)
        {
          return {fiber.length,
                  fiber.radius,
                  static_cast<double>(fiber.n_elements),
                  static_cast<double>(fiber.n_nodes)};
        }



        /** Open @p path, or say which older file there is instead. */
        std::unique_ptr<const Hdf5Reader>
        open(const std::string &path, const MPI_Comm communicator)
        {
          try
            {
              return std::make_unique<const Hdf5Reader>(path, communicator);
            }
          catch (const InputError &error)
            {
              const std::filesystem::path damaged(path);
              const auto older = files(damaged.parent_path().string());
              const auto place =
                std::lower_bound(older.begin(), older.end(), damaged);
              if (place == older.begin() || place == older.end() ||
                  *place != damaged)
                throw;
              throw InputError(std::string(error.what()) + " Remove it to " +
                               "resume from \"" + std::prev(place)->string() +
                               "\".");
            }
        }
      } // namespace Checkpoint
    }   // namespace internal



    Checkpoint::Checkpoint(const System::FiberSpace &space,
                           const std::string        &directory,
                           const unsigned int        n_kept)
      : space(space)
      , folder(internal::Checkpoint::folder(directory))
      , n_kept(n_kept)
    {
    }



    void
    Checkpoint::write(const Position      &position,
                      const System::State &state,
                      const Save          &save,
                      const std::string   &other_path) const
    {
      const MPI_Comm communicator = space.communicator();
      write_together([this]() { create_folder(folder); }, communicator);

      const std::string path =
        other_path.empty()
          ? folder + "/step-" + Utilities::int_to_string(position.number, 5) +
              ".h5"
          : other_path;
      Hdf5Writer archive(path, communicator);
      write_scene(archive);
      archive.write_text("position/stage", position.stage);
      archive.write_text("position/settings", position.settings);
      archive.write_text("position/history", position.history);
      archive.write_number("position/number", position.number);
      archive.write_number("position/step", state.step);
      archive.write_number("position/load_factor", state.load_factor);

      System::write_blocks(archive, "fibers/blocks", state, state.current());
      save(archive);
      archive.commit();
      if (other_path.empty())
        write_together([&]() { tidy_up(path); }, communicator);
    }



    void
    Checkpoint::write_scene(ArchiveWriter &archive) const
    {
      archive.write_number("schema", schema);
      archive.write_text("fibers/element", space.element().name());

      std::vector<double> values;
      const auto          owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const auto fiber = internal::Checkpoint::identity(space.fiber(f));
          values.insert(values.end(), fiber.begin(), fiber.end());
        }
      archive.write(
        "fibers/identity", owned.first, space.n_fibers(), values, 4);
    }



    void
    Checkpoint::tidy_up(const std::string &newest) const
    {
      auto files = internal::Checkpoint::files(folder);
      while (files.back() != newest)
        {
          std::filesystem::remove(files.back());
          files.pop_back();
        }
      for (std::size_t i = 0; i + n_kept < files.size(); ++i)
        std::filesystem::remove(files[i]);
    }



    std::string
    Checkpoint::last(const std::string &directory, const MPI_Comm communicator)
    {
      return ask_first_rank(
        [&]() { return internal::Checkpoint::last_file(directory); },
        communicator);
    }



    void
    Checkpoint::require_one(const std::string &directory,
                            const MPI_Comm     communicator)
    {
      last(directory, communicator);
    }



    void
    Checkpoint::remove_all(const std::string &directory)
    {
      for (const auto &file :
           internal::Checkpoint::files(internal::Checkpoint::folder(directory)))
        std::filesystem::remove(file);
    }



    void
    Checkpoint::check_scene(const ArchiveReader &archive,
                            const std::string   &path) const
    {
      const std::string  begin = "The checkpoint \"" + path + "\" ";
      const unsigned int found =
        archive.has("schema") ? archive.read_number("schema") : 0;
      require(found == schema,
              begin + "has layout " + std::to_string(found) +
                ", and this program reads layout " + std::to_string(schema) +
                ": resume it with the version that wrote it.");

      const auto element = archive.read_text("fibers/element");
      require(element == space.element().name(),
              begin + "is of \"" + element +
                "\" elements, and the scene has \"" + space.element().name() +
                "\" ones.");
      const auto n_fibers = archive.n_rows("fibers/identity");
      require(n_fibers == space.n_fibers(),
              begin + "is of " + std::to_string(n_fibers) +
                " fibers, and the scene has " +
                std::to_string(space.n_fibers()) + ".");

      const auto owned  = space.owned_fibers();
      const auto values = archive.read(
        "fibers/identity", owned.first, owned.second - owned.first, 4);
      unsigned int wrong = space.n_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const auto    fiber = internal::Checkpoint::identity(space.fiber(f));
          const double *there = values.data() + 4 * (f - owned.first);
          for (unsigned int i = 0; i < 4; ++i)
            if (std::abs(there[i] - fiber[i]) > 1e-10 * std::abs(fiber[i]))
              wrong = std::min(wrong, f);
        }
      wrong = Utilities::MPI::min(wrong, space.communicator());
      require(wrong == space.n_fibers(),
              begin + "is of another scene: fiber " + std::to_string(wrong) +
                " has another length, radius or number of elements there.");
    }



    Checkpoint::Position
    Checkpoint::read(const std::string &path,
                     System::State     &state,
                     const Load        &load,
                     const Load        &prepare) const
    {
      const auto opened =
        internal::Checkpoint::open(path, space.communicator());
      const ArchiveReader &archive = *opened;
      check_scene(archive, path);

      Position position;
      position.stage    = archive.read_text("position/stage");
      position.settings = archive.read_text("position/settings");
      position.history  = archive.read_text("position/history");
      position.number   = archive.read_number("position/number");
      state.step        = archive.read_number("position/step");
      state.load_factor = archive.read_number("position/load_factor");

      prepare(archive);
      state.set_owned(System::read_positions(archive, "fibers/blocks", state));
      state.accept();

      load(archive);
      return position;
    }
  } // namespace IO
} // namespace Heddle
