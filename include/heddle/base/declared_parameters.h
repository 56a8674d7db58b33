#ifndef heddle_base_declared_parameters_h
#define heddle_base_declared_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace Heddle
{
  using namespace dealii;

  /**
   * The names that a ParameterHandler knows, for messages that help: which
   * sections and parameters there are, what is allowed for each, and which
   * name may have been meant by one that does not exist.
   */
  class DeclaredParameters
  {
  public:
    DeclaredParameters(const ParameterHandler &prm);

    bool
    has_section(const std::vector<std::string> &path) const;

    bool
    has_parameter(const std::vector<std::string> &path,
                  const std::string              &name) const;

    /** Return whether @p value is allowed for a parameter. */
    bool
    admits(const std::vector<std::string> &path,
           const std::string              &name,
           const std::string              &value) const;

    /**
     * Whether all numbers of @p value, if the parameter has any, are such that
     * they can be computed with.
     */
    bool
    is_in_range(const std::vector<std::string> &path,
                const std::string              &name,
                const std::string              &value) const;

    /** Return in words what is allowed for a parameter. */
    std::string
    allowed(const std::vector<std::string> &path,
            const std::string              &name) const;

    /** Return the value of a parameter that is not set. */
    const std::string &
    usual_value(const std::vector<std::string> &path,
                const std::string              &name) const;

    /**
     * Return the question whether another section was meant, as in
     * `; did you mean "Contact"?`, or a full stop if none is similar.
     */
    std::string
    suggest_section(const std::vector<std::string> &path) const;

    /** Likewise for a parameter, here first and then in other sections. */
    std::string
    suggest_parameter(const std::vector<std::string> &path,
                      const std::string              &name) const;

  private:
    struct Parameter
    {
      std::string name;
      std::string pattern;
      std::string usual_value;
    };

    /** Return the parameter, or nullptr if there is none of this name. */
    const Parameter *
    find(const std::vector<std::string> &path, const std::string &name) const;

    std::set<std::string>                         sections;
    std::map<std::string, std::vector<Parameter>> parameters;
  };

  /** Return the sections @p path joined by slashes, as in "Contact/Friction".
   */
  std::string
  join_path(const std::vector<std::string> &path);

  /**
   * Return the number of letters to insert, delete, replace or exchange with
   * their neighbor to get from @p a to @p b; case does not count.
   */
  unsigned int
  edit_distance(const std::string &a, const std::string &b);
} // namespace Heddle

#endif
