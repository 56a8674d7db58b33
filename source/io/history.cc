#include <heddle/io/history.h>

#include <deal.II/base/mpi.h>

namespace Heddle
{
  namespace IO
  {
    History::History(const std::string         &directory,
                     const MPI_Comm             communicator,
                     const std::vector<Column> &more_columns)
      : path(directory + "/history.csv")
      , first_rank(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      for (const Column &column :
           std::vector<Column>{{"step", "-"},
                               {"stage", "-"},
                               {"load_factor", "-"},
                               {"newton_iterations", "-"},
                               {"residual_ratio", "-"}})
        table.add_column(column.first, column.second);
      for (const Column &column : more_columns)
        table.add_column(column.first, column.second);
    }



    void
    History::add(const std::map<std::string, double> &row)
    {
      table.begin_row();
      for (const auto &entry : row)
        table.set(entry.first, entry.second);
      write();
    }



    void
    History::write() const
    {
      if (first_rank)
        table.write(path);
    }



    std::string
    History::csv() const
    {
      return table.csv();
    }



    void
    History::resume(const std::string &csv)
    {
      table.read(csv);
    }
  } // namespace IO
} // namespace Heddle
