#ifndef heddle_io_checkpoint_h
#define heddle_io_checkpoint_h

#include <heddle/base/archive.h>
#include <heddle/system/fiber_space.h>
#include <heddle/system/state.h>

#include <functional>
#include <string>

namespace Heddle
{
  namespace IO
  {
    /**
     * The files from which a run goes on: DIRECTORY/checkpoint/step-00012.h5.
     *
     * A file appears under its name when it is complete, and only then are the
     * oldest ones removed: a run that is killed at any moment leaves its last
     * checkpoint. Fibers, nodes and contacts are numbered by global ids, so
     * any number of ranks may read it.
     */
    class Checkpoint
    {
    public:
      /** Where the run stood. */
      struct Position
      {
        std::string  stage;
        unsigned int number = 0; /**< of the load step, over all stages */
        std::string  settings;   /**< settings_text() */
        std::string  history;    /**< text of history.csv */
      };

      using Save = std::function<void(ArchiveWriter &)>;
      using Load = std::function<void(const ArchiveReader &)>;

      /** Number of the layout of the files; older and newer are refused. */
      static constexpr unsigned int schema = 10;

      /** The last @p n_kept files stay. */
      Checkpoint(const System::FiberSpace &space,
                 const std::string        &directory,
                 const unsigned int        n_kept);

      /**
       * Write @p state, and what @p save adds: the parts of the contributions.
       * To the file @p other_path, if it is given, beside the numbered ones.
       * @note Collective.
       */
      void
      write(const Position      &position,
            const System::State &state,
            const Save          &save,
            const std::string   &other_path = "") const;

      /**
       * Return the path of the last checkpoint in @p directory, as the first
       * rank sees it; without one, throw InputError.
       * @note Collective.
       */
      static std::string
      last(const std::string &directory, const MPI_Comm communicator);

      /**
       * Throw InputError if there is no checkpoint in @p directory.
       * @note Collective.
       */
      static void
      require_one(const std::string &directory, const MPI_Comm communicator);

      /** Remove all of @p directory, if there are any. Local. */
      static void
      remove_all(const std::string &directory);

      /**
       * Set @p state, current and accepted, from the file @p path, let @p load
       * take what belongs to the contributions, and return where the run
       * stood. Before, @p prepare may give the state the fields that it had. A
       * file of other fibers throws InputError.
       * @note Collective.
       */
      Position
      read(
        const std::string &path,
        System::State     &state,
        const Load        &load,
        const Load        &prepare = [](const ArchiveReader &) {}) const;

    private:
      void
      write_scene(ArchiveWriter &archive) const;

      void
      check_scene(const ArchiveReader &archive, const std::string &path) const;

      /**
       * Remove what is older than the last files, and what is later than the
       * @p newest: it belongs to an earlier run that went another way. Local.
       */
      void
      tidy_up(const std::string &newest) const;

      const System::FiberSpace &space;
      const std::string         folder;
      const unsigned int        n_kept;
    };
  } // namespace IO
} // namespace Heddle

#endif
