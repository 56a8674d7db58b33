#include <heddle/base/exceptions.h>
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
    } // namespace



    CsvTable::CsvTable(std::istream                   &input,
                       const std::string              &name,
                       const std::vector<std::string> &required,
                       const std::vector<std::string> &optional)
      : input(input)
      , name(name)
    {
      const std::string wanted =
        join(required) +
        (optional.empty() ? "" : " and perhaps " + join(optional));
      if (!read_line())
        throw InputError(name +
                         ": the file is empty; its first line must name "
                         "the columns " +
                         wanted + ".");
      header = values;
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
             " columns; give one value for each, separated by commas.");
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
             "'; give a finite number.");
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
      for (std::string line; std::getline(input, line);)
        {
          ++line_number;
          line = dealii::Utilities::trim(line.substr(0, line.find('#')));
          if (line.empty())
            continue;
          values.clear();
          line += ',';
          std::istringstream words(line);
          for (std::string word; std::getline(words, word, ',');)
            values.push_back(dealii::Utilities::trim(word));
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
