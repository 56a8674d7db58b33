#include <heddle/base/declared_parameters.h>
#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/number_range.h>
#include <heddle/base/parameter_file.h>
#include <heddle/base/settings.h>
#include <heddle/base/text_lines.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace Heddle
{
  namespace internal
  {
    namespace ParameterFile
    {
      /** Return the sections of a path like "/Contact/Friction". */
      std::vector<std::string>
      split_path(const std::string &path)
      {
        std::vector<std::string> parts;
        for (const std::string &part : Utilities::split_string_list(path, '/'))
          if (!part.empty())
            parts.push_back(part);
        return parts;
      }



      bool
      begins_with(const std::vector<std::string> &path,
                  const std::vector<std::string> &start)
      {
        return path.size() >= start.size() &&
               std::equal(start.begin(), start.end(), path.begin());
      }



      /** Return N if @p section is "@p name N" with N from 1 on, 0 if not. */
      unsigned int
      number_of(const std::string &section, const std::string &name)
      {
        const std::string start = name + " ";
        if (section.compare(0, start.size(), start) != 0)
          return 0;
        const std::string digits = section.substr(start.size());
        const bool        is_number =
          !digits.empty() && digits.size() < 7 && digits.front() != '0' &&
          digits.find_first_not_of("0123456789") == std::string::npos;
        return is_number ? std::stoul(digits) : 0;
      }



      /** Return the text of @p exception, without where it was thrown. */
      std::string
      sentence(const ExceptionBase &exception)
      {
        std::ostringstream text;
        exception.print_info(text);
        return Utilities::trim(text.str());
      }
    } // namespace ParameterFile
  }   // namespace internal



  ParameterFile::ParameterFile(const std::string &name,
                               const MPI_Comm     communicator)
    : communicator(communicator)
    , file_name(name)
    , file_text(read_file(name, "parameter file", communicator))
  {
    scan(relative_to("", file_name), file_text);
  }



  void
  ParameterFile::set(const std::string &assignment)
  {
    const std::string fault = no_text(assignment);
    require(fault.empty(), "--set: " + fault + "; give it in UTF-8.");
    const std::string where  = "--set \"" + assignment + "\"";
    const auto        equals = assignment.find('=');
    require(equals != std::string::npos,
            where + ": expected \"Section/Name=value\".");

    auto path =
      internal::ParameterFile::split_path(assignment.substr(0, equals));
    require(!path.empty(), where + ": the name of a parameter is missing.");
    const std::string name = path.back();
    path.pop_back();
    statements.push_back(
      {where, path, name, Utilities::trim(assignment.substr(equals + 1))});
  }



  unsigned int
  ParameterFile::count_sections(const std::string &path,
                                const std::string &name) const
  {
    const auto parent = internal::ParameterFile::split_path(path);

    std::set<unsigned int> numbers;
    for (const Statement &statement : statements)
      if (statement.path.size() > parent.size() &&
          internal::ParameterFile::begins_with(statement.path, parent))
        numbers.insert(internal::ParameterFile::number_of(
          statement.path[parent.size()], name));
    numbers.erase(0);

    unsigned int expected = 1;
    for (const unsigned int number : numbers)
      {
        require(number == expected,
                "There is a section \"" + name + " " + std::to_string(number) +
                  "\" in \"" + join_path(parent) + "\", but no \"" + name +
                  " " + std::to_string(expected) +
                  "\": number them from 1 on, without gaps.");
        ++expected;
      }
    return numbers.size();
  }



  bool
  ParameterFile::mentions(const std::string &path) const
  {
    const auto wanted = internal::ParameterFile::split_path(path);
    for (const Statement &statement : statements)
      {
        auto here = statement.path;
        if (!statement.name.empty())
          here.push_back(statement.name);
        if (internal::ParameterFile::begins_with(here, wanted))
          return true;
      }
    return false;
  }



  void
  ParameterFile::apply(ParameterHandler &prm) const
  {
    ParameterAcceptor::declare_all_parameters(prm);
    const DeclaredParameters declared(prm);

    for (const Statement &statement : statements)
      {
        check(statement, declared);
        if (statement.name.empty())
          continue;
        for (const std::string &section : statement.path)
          prm.enter_subsection(section);
        prm.set(statement.name, statement.value);
        for (unsigned int i = 0; i < statement.path.size(); ++i)
          prm.leave_subsection();
      }

    try
      {
        ParameterAcceptor::parse_all_parameters(prm);
      }
    catch (const ExceptionBase &exception)
      {
        throw InputError(internal::ParameterFile::sentence(exception));
      }
  }



  std::vector<ParameterFile::Entry>
  ParameterFile::unusual(const ParameterHandler &prm) const
  {
    const auto full_name = [](const Statement &statement) {
      return statement.path.empty()
               ? statement.name
               : join_path(statement.path) + "/" + statement.name;
    };
    std::map<std::string, const Statement *> last;
    for (const Statement &statement : statements)
      last[full_name(statement)] = &statement;

    const DeclaredParameters declared(prm);
    std::vector<Entry>       entries;
    for (const Statement &statement : statements)
      {
        const auto &[where, path, name, value] = statement;
        const std::string entry                = full_name(statement);
        if (!name.empty() && last[entry] == &statement &&
            !same_value(value, declared.usual_value(path, name)))
          entries.push_back({entry, where});
      }
    return entries;
  }



  const std::string &
  ParameterFile::name() const
  {
    return file_name;
  }



  const std::string &
  ParameterFile::text() const
  {
    return file_text;
  }



  void
  ParameterFile::check(const Statement          &statement,
                       const DeclaredParameters &declared)
  {
    const auto &[where, path, name, value] = statement;
    if (!declared.has_section(path))
      throw InputError(where + ": no section \"" + join_path(path) + "\"" +
                       declared.suggest_section(path));
    if (name.empty())
      return;

    const std::string in = path.empty()
                             ? " outside of all sections"
                             : " in section \"" + join_path(path) + "\"";
    if (!declared.has_parameter(path, name))
      throw InputError(where + ": no parameter \"" + name + "\"" + in +
                       declared.suggest_parameter(path, name));
    if (!declared.admits(path, name, value))
      throw InputError(where + ": \"" + name + "\"" + in + " is \"" + value +
                       "\", but must be " + declared.allowed(path, name) + ".");
    if (!declared.is_in_range(path, name, value))
      throw InputError(where + ": \"" + name + "\"" + in + " is \"" + value +
                       "\"; give " + range_in_words + ".");
  }



  void
  ParameterFile::scan(const std::string &file, const std::string &content)
  {
    files.push_back(file);
    places.emplace_back();
    const std::size_t  depth = open_sections.size();
    std::istringstream in(content);
    std::string        physical_line;
    std::string        line;

    for (unsigned int number = 1; take_line(in, physical_line); ++number)
      {
        const std::string where = file + ":" + std::to_string(number);
        // A comment ends with its line, a statement only without a backslash.
        physical_line =
          Utilities::trim(physical_line.substr(0, physical_line.find('#')));
        const std::string fault = no_text(physical_line);
        require(fault.empty(),
                where + ": " + fault + "; save the file in UTF-8.");
        line += physical_line;
        if (line.empty())
          continue;
        if (line.back() == '\\')
          {
            line.back() = ' ';
            continue;
          }
        read_statement(line, where, depth);
        line.clear();
      }

    require(line.empty(),
            file + ": the last statement ends with a backslash, but nothing "
                   "follows: remove it, or go on in another line.");
    require(open_sections.size() == depth,
            file + ": the section \"" + join_path(open_sections) +
              "\" is not closed by \"end\".");
    files.pop_back();
    places.pop_back();
  }



  void
  ParameterFile::read_statement(const std::string &line,
                                const std::string &where,
                                const std::size_t  depth)
  {
    const auto        space   = line.find_first_of(" \t");
    const std::string command = line.substr(0, space);
    const std::string rest =
      space == std::string::npos ? "" : Utilities::trim(line.substr(space));

    if (command == "subsection" || command == "SUBSECTION")
      {
        require(!rest.empty(), where + ": this section has no name.");
        open_sections.push_back(rest);
        statements.push_back({where, open_sections, "", ""});
      }
    else if (command == "end" || command == "END")
      {
        require(rest.empty(), where + ": \"" + rest + "\" follows an \"end\".");
        require(open_sections.size() > depth,
                where + ": this \"end\" closes no section.");
        open_sections.pop_back();
      }
    else if (command == "set" || command == "SET")
      {
        const auto        equals = rest.find('=');
        const std::string name   = Utilities::trim(rest.substr(0, equals));
        require(equals != std::string::npos && !name.empty(),
                where + ": expected \"set Name = value\".");
        auto entry = open_sections;
        entry.push_back(name);
        const auto first = places.back().insert({entry, where});
        require(first.second,
                where + ": \"" + join_path(entry) + "\" was set in " +
                  first.first->second + " already: keep one of them.");
        statements.push_back({where,
                              open_sections,
                              name,
                              Utilities::trim(rest.substr(equals + 1))});
      }
    else if (command == "include" || command == "INCLUDE")
      include(rest, where);
    else
      throw InputError(where + ": \"" + command +
                       "\" is none of the statements \"subsection\", "
                       "\"set\", \"end\" and \"include\".");
  }



  void
  ParameterFile::include(const std::string &name, const std::string &where)
  {
    const std::string file = relative_to(files.back(), name);
    require(std::find(files.begin(), files.end(), file) == files.end(),
            where + ": the file \"" + file + "\" includes itself.");

    std::string content;
    try
      {
        content = read_file(file, "parameter file", communicator);
      }
    catch (const InputError &error)
      {
        throw InputError(where + ": " + error.what());
      }
    scan(file, content);
  }
} // namespace Heddle
