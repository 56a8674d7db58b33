#ifndef heddle_io_history_h
#define heddle_io_history_h

#include <heddle/base/table.h>

#include <mpi.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Heddle
{
  namespace IO
  {
    /**
     * The curves of a run, history.csv: one row per accepted load step, written
     * anew after each.
     *
     * The columns that every run has come first; a scene adds what it measures.
     * All ranks hold the table, the first one writes it.
     */
    class History
    {
    public:
      /** Column and unit. */
      using Column = std::pair<std::string, std::string>;

      /**
       * step, stage (counted from 0), load_factor, newton_iterations,
       * residual_ratio, then @p more_columns.
       */
      History(const std::string         &directory,
              const MPI_Comm             communicator,
              const std::vector<Column> &more_columns = {});

      bool
      has_column(const std::string &name) const
      {
        return table.has_column(name);
      }

      /** Append a row; columns that are not named stay empty. */
      void
      add(const std::map<std::string, double> &row);

      /** Write the table as it is. */
      void
      write() const;

      /** The table, for a checkpoint; and back, all rows replaced. */
      std::string
      csv() const;
      void
      resume(const std::string &csv);

    private:
      const std::string path;
      const bool        first_rank;
      StepTable         table;
    };
  } // namespace IO
} // namespace Heddle

#endif
