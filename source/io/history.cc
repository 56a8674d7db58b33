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
                               {"residual", "N"},
                               {"contact_elements", "-"},
                               {"active_contact_elements", "-"},
                               {"max_penetration_ratio", "-"},
                               {"min_penalty", "N/mm^2"},
                               {"max_penalty", "N/mm^2"},
                               {"energy_elastic", "N mm"},
                               {"energy_contact", "N mm"}})
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
