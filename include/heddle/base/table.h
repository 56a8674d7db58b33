#ifndef heddle_base_table_h
#define heddle_base_table_h

#include <string>
#include <vector>

namespace Heddle
{
  /**
   * One row per load step, one column per quantity: a curve in the making.
   * It is written as CSV with one line of names and units, as in
   * `load_factor[-],force_x[N]`, and numbers of ten digits.
   */
  class StepTable
  {
  public:
    /** Append a column. All columns are declared before the first row. */
    void
    add_column(const std::string &name, const std::string &unit);

    bool
    has_column(const std::string &name) const;

    /** Begin a row. Entries that are not set stay empty in the file. */
    void
    begin_row();

    /** Set the entry of the last row in the column @p name. */
    void
    set(const std::string &name, const double value);

    /** Return the entry of row @p row in the column @p name, NaN if unset. */
    double
    get(const std::size_t row, const std::string &name) const;

    /** Return the table as CSV. */
    std::string
    csv() const;

    /** Write the table as CSV to the file @p name, beside it and renamed. */
    void
    write(const std::string &name) const;

    /**
     * Replace the rows by those of @p csv, the text that csv() returned for
     * the same columns: a run that is resumed goes on with its old table.
     */
    void
    read(const std::string &csv);

  private:
    std::string
    head() const;

    static std::string
    line(const std::vector<double> &row);

    std::size_t
    column(const std::string &name) const;

    std::vector<std::string>         names;
    std::vector<std::string>         units;
    std::vector<std::vector<double>> rows;

    /** The lines of all rows but the last: a table grows row by row, and is
     * written after each. */
    std::string finished;
  };
} // namespace Heddle

#endif
