#ifndef heddle_base_parameter_file_h
#define heddle_base_parameter_file_h

#include <deal.II/base/parameter_acceptor.h>

#include <mpi.h>

#include <map>
#include <string>
#include <vector>

namespace Heddle
{
  using namespace dealii;

  class DeclaredParameters;

  /**
   * The text of a parameter file, statement by statement, and what the command
   * line sets on top of it.
   *
   * The file is read before the parameters are declared, for two reasons: a
   * list in a parameter file is a sequence of numbered sections, *Support 1*,
   * *Support 2*, and so on, whose number decides how many objects there are to
   * declare parameters; and each error can be traced to its file and line. The
   * sequence is therefore
   * @code
   *   const ParameterFile file("scene.prm");
   *   // construct as many objects as file.count_sections() says
   *   file.apply();
   * @endcode
   *
   * A file is what deal.II's ParameterHandler reads: `subsection`, `end`, `set
   * Name = value`, `include`, comments from # on, and lines continued by a
   * backslash. Files are included relative to the file that names them. They
   * are text in UTF-8, whose lines end as on any system.
   */
  class ParameterFile
  {
  public:
    /** A file that sets nothing. */
    ParameterFile() = default;

    /**
     * Read the file @p name and all that it includes, or throw InputError. The
     * first rank reads for all of @p communicator. @note Collective.
     */
    ParameterFile(const std::string &name,
                  const MPI_Comm     communicator = MPI_COMM_SELF);

    /**
     * Set one more parameter, after those of the file. @p assignment is a text
     * like "Contact/Friction coefficient=0.3".
     */
    void
    set(const std::string &assignment);

    /**
     * Return the largest N for which there is a section "@p name N" inside the
     * section @p path, as in count_sections("/Supports", "Support").
     */
    unsigned int
    count_sections(const std::string &path, const std::string &name) const;

    /** Return whether there is a section or a parameter @p path. */
    bool
    mentions(const std::string &path) const;

    /**
     * Declare the parameters of all objects that accept some, give them the
     * values of this file, and let the objects check them. Throw InputError
     * for an unknown name, for a value outside what is allowed, and for
     * whatever the objects complain about.
     */
    void
    apply(ParameterHandler &prm = ParameterAcceptor::prm) const;

    /** A parameter that is set, such as "Contact/Enabled", and where. */
    struct Entry
    {
      std::string path, where;
    };

    /**
     * Return the parameters that this file gives another value than the one
     * they have by themselves in @p prm, in the order of the file, each where
     * it was set last.
     */
    std::vector<Entry>
    unusual(const ParameterHandler &prm) const;

    /** Return the name of the file. */
    const std::string &
    name() const;

    /** Return the file as it was read, without what it includes. */
    const std::string &
    text() const;

  private:
    /** A `subsection` or a `set`, with where it was found. */
    struct Statement
    {
      std::string              where;
      std::vector<std::string> path;
      std::string              name; /**< empty for a subsection */
      std::string              value;
    };

    /** Throw InputError if the statement is about nothing that is declared. */
    static void
    check(const Statement &statement, const DeclaredParameters &declared);

    void
    scan(const std::string &file, const std::string &content);

    /** A statement may close the sections beyond @p depth open ones only. */
    void
    read_statement(const std::string &line,
                   const std::string &where,
                   const std::size_t  depth);

    void
    include(const std::string &name, const std::string &where);

    const MPI_Comm         communicator = MPI_COMM_SELF;
    const std::string      file_name;
    const std::string      file_text;
    std::vector<Statement> statements;

    /** Where each entry of a file was set, by sections and name. */
    using Places = std::map<std::vector<std::string>, std::string>;

    // While reading: the files and the sections that are open, and what those
    // files set by themselves. What a file includes may be set again.
    std::vector<std::string> files;
    std::vector<std::string> open_sections;
    std::vector<Places>      places;
  };
} // namespace Heddle

#endif
