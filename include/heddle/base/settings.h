#ifndef heddle_base_settings_h
#define heddle_base_settings_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Heddle
{
  using namespace dealii;

  /**
   * Return whether two texts are the same value: numbers, and the entries of
   * lists of them, are compared as numbers, so that 0.0 is 0.
   */
  bool
  same_value(const std::string &a, const std::string &b);

  /**
   * Return all values in force, one "Section/Name=value" in a line, as the
   * command line takes them.
   */
  std::string
  settings_text(const ParameterHandler &prm);

  /**
   * Return what is not the same in two such texts, in words, such as
   * "Contact/Friction coefficient is 0.2, and was 0.1".
   */
  std::vector<std::string>
  changed_settings(const std::string &before, const std::string &now);
} // namespace Heddle

#endif
