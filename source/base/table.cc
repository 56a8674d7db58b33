#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/table.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Heddle
{
  using namespace dealii;



  void
  StepTable::add_column(const std::string &name, const std::string &unit)
  {
    Assert(rows.empty(), ExcMessage("Columns come before rows."));
    require(std::find(names.begin(), names.end(), name) == names.end(),
            "A table has two columns \"" + name + "\".");
    names.push_back(name);
    units.push_back(unit);
  }



  bool
  StepTable::has_column(const std::string &name) const
  {
    return std::find(names.begin(), names.end(), name) != names.end();
  }



  void
  StepTable::begin_row()
  {
    if (!rows.empty())
      finished += line(rows.back());
    rows.emplace_back(names.size(), std::numeric_limits<double>::quiet_NaN());
  }



  void
  StepTable::set(const std::string &name, const double value)
  {
    Assert(!rows.empty(), ExcMessage("There is no row yet."));
    // Nothing is to be read as "-0".
    rows.back()[column(name)] = value + 0.;
  }



  double
  StepTable::get(const std::size_t row, const std::string &name) const
  {
    AssertIndexRange(row, rows.size());
    return rows[row][column(name)];
  }



  std::string
  StepTable::csv() const
  {
    return head() + '\n' + finished + (rows.empty() ? "" : line(rows.back()));
  }



  std::string
  StepTable::line(const std::vector<double> &row)
  {
    std::ostringstream out;
    out << std::setprecision(10);
    for (std::size_t i = 0; i < row.size(); ++i)
      {
        if (!std::isnan(row[i]))
          out << row[i];
        out << (i + 1 < row.size() ? ',' : '\n');
      }
    return out.str();
  }



  void
  StepTable::write(const std::string &name) const
  {
    write_file(name, csv());
  }



  void
  StepTable::read(const std::string &csv)
  {
    std::istringstream in(csv);
    std::string        text;
    std::getline(in, text);
    const auto found  = Utilities::split_string_list(text, ',');
    const auto wanted = Utilities::split_string_list(head(), ',');
    const auto differ =
      std::mismatch(found.begin(), found.end(), wanted.begin(), wanted.end());
    const auto name_or_none = [](const auto column, const auto end) {
      return column == end ? "no more column"
                           : "the column \"" + *column + "\"";
    };
    require(text == head(),
            "A table has " + name_or_none(differ.first, found.end()) +
              " where this scene has " +
              name_or_none(differ.second, wanted.end()) +
              ": it was written for another scene.");

    rows.clear();
    finished.clear();
    while (std::getline(in, text))
      {
        begin_row();
        std::istringstream entries(text);
        std::string        entry;
        for (double &value : rows.back())
          if (std::getline(entries, entry, ',') && !entry.empty())
            value = std::strtod(entry.c_str(), nullptr);
      }
  }



  std::string
  StepTable::head() const
  {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
      text += (i > 0 ? "," : "") + names[i] + "[" + units[i] + "]";
    return text;
  }



  std::size_t
  StepTable::column(const std::string &name) const
  {
    const auto found = std::find(names.begin(), names.end(), name);
    AssertThrow(found != names.end(),
                ExcMessage("The table has no column \"" + name + "\"."));
    return found - names.begin();
  }
} // namespace Heddle
