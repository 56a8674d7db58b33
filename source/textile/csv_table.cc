#include <heddle/base/exceptions.h>
#include <heddle/base/number_range.h>
#include <heddle/base/text_lines.h>
#include <heddle/textile/csv_table.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      std::string
      join(const std::vector<std::string> &words)
      {
        std::string text;
        for (const std::string &word : words)
          text += (text.empty() ? "" : ",") + word;
        return text;
      }



      /** "fiber,x,y,z and perhaps radius". */
      std::string
      names_in_words(const std::vector<std::string> &required,
                     const std::vector<std::string> &optional)
      {
        return join(required) +
               (optional.empty() ? "" : " and perhaps " + join(optional));
      }



      /** What separates the names of columns. */
      char
      separator_of(const std::string &line)
      {
        for (const char separator : {',', ';', '\t'})
          if (line.find(separator) != std::string::npos)
            return separator;
        return ',';
      }



      std::string
      without_quotes(const std::string &word)
      {
        return word.size() > 1 && word.front() == '"' && word.back() == '"'
                 ? word.substr(1, word.size() - 2)
                 : word;
      }
    } // namespace



    CsvTable::CsvTable(std::istream                   &input,
                       const std::string              &name,
                       const std::vector<std::string> &required,
                       const std::vector<std::string> &optional)
      : input(input)
      , name(name)
    {
      if (!read_line())
        throw InputError(name +
                         ": the file is empty; its first line must name "
                         "the columns " +
                         names_in_words(required, optional) + ".");
      header = values;
      check_header(required, optional);
    }



    void
    CsvTable::check_header(const std::vector<std::string> &required,
                           const std::vector<std::string> &optional) const
    {
      const std::string wanted = names_in_words(required, optional);
      if (header.size() == 1 && header[0].find(' ') != std::string::npos)
        fail("'" + header[0] +
             "' has no commas; this line must name the columns " + wanted +
             ", separated by commas, semicolons or tabs, as values are.");
      for (const std::string &column : required)
        if (!has(column))
          fail("there is no column '" + column +
               "'; this line must name the columns " + wanted + ".");
      for (const std::string &column : header)
        {
          if (std::count(header.begin(), header.end(), column) > 1)
            fail("column '" + column + "' appears twice; name it once.");
          if (std::count(required.begin(), required.end(), column) +
                std::count(optional.begin(), optional.end(), column) ==
              0)
            fail("column '" + column +
                 "' is unknown; this line may name the columns " + wanted +
                 ".");
        }
    }



    bool
    CsvTable::next()
    {
      if (!read_line())
        return false;
      if (values.size() != header.size())
        fail("found " + std::to_string(values.size()) + " values for " +
             std::to_string(header.size()) +
             " columns; give one value for each, separated by " +
             (separator == ','   ? "commas"
              : separator == ';' ? "semicolons"
                                 : "tabs") +
             ", with decimal points.");
      return true;
    }



    bool
    CsvTable::has(const std::string &column) const
    {
      return std::find(header.begin(), header.end(), column) != header.end();
    }



    std::string
    CsvTable::text(const std::string &column) const
    {
      return values[position(column)];
    }



    double
    CsvTable::number(const std::string &column) const
    {
      const std::string  word = text(column);
      std::istringstream stream(word);
      // Whatever the user's language, the decimal point is a point.
      stream.imbue(std::locale::classic());
      double value;
      stream >> value;
      if (stream.fail() || !stream.eof() || !std::isfinite(value))
        fail("column '" + column + "' holds '" + word +
             (word.find(',') == std::string::npos
                ? "'; give a finite number."
                : "'; give a number with a decimal point."));
      if (!is_in_range(value))
        fail("column '" + column + "' holds '" + word + "'; give " +
             range_in_words + ".");
      return value;
    }



    void
    CsvTable::fail(const std::string &sentence) const
    {
      throw InputError(name + ":" + std::to_string(line_number) + ": " +
                       sentence);
    }



    bool
    CsvTable::read_line()
    {
      for (std::string line; take_line(input, line);)
        {
          ++line_number;
          line                    = line.substr(0, line.find('#'));
          const std::string fault = no_text(line);
          if (!fault.empty())
            fail(fault +
                 "; save the table as comma-separated values in UTF-8.");
          if (dealii::Utilities::trim(line).empty())
            continue;
          if (separator == 0)
            separator = separator_of(line);
          values.clear();
          line += separator;
          std::istringstream words(line);
          for (std::string word; std::getline(words, word, separator);)
            values.push_back(without_quotes(dealii::Utilities::trim(word)));
          return true;
        }
      return false;
    }



    unsigned int
    CsvTable::position(const std::string &column) const
    {
      return std::find(header.begin(), header.end(), column) - header.begin();
    }
  } // namespace Textile
} // namespace Heddle
