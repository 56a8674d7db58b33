#ifndef heddle_textile_csv_table_h
#define heddle_textile_csv_table_h

#include <istream>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /**
     * A table of comma-separated values, read line by line. The first line that
     * is neither blank nor a comment (from `#` to the end of the line) names
     * the columns, in any order. Where it has no comma, semicolons or tabs
     * separate the values, as spreadsheets write them. Values may stand in
     * double quotes, and lines end as on any system. Every error names the file
     * and the line.
     */
    class CsvTable
    {
    public:
      /**
       * Read the header. Throws InputError if it is missing, if a column of
       * @p required is, if one appears twice or is in neither list.
       */
      CsvTable(std::istream                   &input,
               const std::string              &name,
               const std::vector<std::string> &required,
               const std::vector<std::string> &optional);

      /** Move to the next line of values; false at the end of the file. */
      bool
      next();

      /** Whether there is such a column. */
      bool
      has(const std::string &column) const;

      /** Value of the current line. @pre The column is there. */
      std::string
      text(const std::string &column) const;

      /** The same as a finite number; throws InputError if it is not one. */
      double
      number(const std::string &column) const;

      /** Throw an InputError that begins with file and line. */
      [[noreturn]] void
      fail(const std::string &sentence) const;

      /** Number of the current line, the file's first being 1. */
      unsigned int
      line() const
      {
        return line_number;
      }

    private:
      /** Cut the next line that is not blank; false at the end. */
      bool
      read_line();

      /** Refuse columns that are missing, twice, or of no meaning. */
      void
      check_header(const std::vector<std::string> &required,
                   const std::vector<std::string> &optional) const;

      unsigned int
      position(const std::string &column) const;

      std::istream            &input;
      const std::string        name;
      unsigned int             line_number = 0;
      char                     separator   = 0; /**< 0: not known yet */
      std::vector<std::string> header;
      std::vector<std::string> values;
    };
  } // namespace Textile
} // namespace Heddle

#endif
