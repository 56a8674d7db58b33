#ifndef heddle_base_choice_h
#define heddle_base_choice_h

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <string>
#include <vector>

namespace Heddle
{
  using namespace dealii;

  /*
   * A choice is an enum whose values the user names by words. Beside it is the
   * one table of them,
   *
   *   const char *word(const Kind kind);
   *
   * a switch without default, so that the compiler tells of a value without a
   * word. Behind it nullptr is returned: the values, counted from 0, end where
   * there is no word.
   */

  /** Return the values of a choice, in the order of the enum. */
  template <typename Value>
  std::vector<Value>
  all_choices()
  {
    std::vector<Value> values;
    for (int i = 0; word(static_cast<Value>(i)) != nullptr; ++i)
      values.push_back(static_cast<Value>(i));
    return values;
  }



  /** Return the words of a choice as deal.II's pattern has them: "a|b|c". */
  template <typename Value>
  std::string
  words_of_choice()
  {
    std::string words;
    for (const Value value : all_choices<Value>())
      words += (words.empty() ? "" : "|") + std::string(word(value));
    return words;
  }



  /** Return the value that @p text stands for, which must be one of the words.
   */
  template <typename Value>
  Value
  choice(const std::string &text)
  {
    for (const Value value : all_choices<Value>())
      if (Utilities::trim(text) == word(value))
        return value;
    AssertThrow(
      false,
      ExcMessage("\"" + text + "\" is none of " + words_of_choice<Value>()));
    return {};
  }



  /**
   * Declare an entry in the section of @p owner whose words are those of the
   * choice, and let it set @p value, which is its default. @p documentation
   * says what each of them means.
   */
  template <typename Value>
  void
  add_choice(ParameterAcceptor &owner,
             const std::string &entry,
             Value             &value,
             const std::string &documentation)
  {
    ParameterHandler &prm = ParameterAcceptor::prm;
    owner.enter_my_subsection(prm);
    prm.declare_entry(entry,
                      word(value),
                      Patterns::Selection(words_of_choice<Value>()),
                      documentation);
    prm.add_action(entry, [&value](const std::string &text) {
      value = choice<Value>(text);
    });
    owner.leave_my_subsection(prm);
  }



  /** The same of a list, which may name each word once. */
  template <typename Value>
  void
  add_choices(ParameterAcceptor  &owner,
              const std::string  &entry,
              std::vector<Value> &values,
              const std::string  &documentation)
  {
    ParameterHandler &prm = ParameterAcceptor::prm;
    std::string       words;
    for (const Value value : values)
      words += (words.empty() ? "" : ", ") + std::string(word(value));
    owner.enter_my_subsection(prm);
    prm.declare_entry(
      entry,
      words,
      Patterns::List(Patterns::Selection(words_of_choice<Value>()),
                     0,
                     all_choices<Value>().size()),
      documentation);
    prm.add_action(entry, [&values](const std::string &text) {
      values.clear();
      for (const std::string &one : Utilities::split_string_list(text))
        values.push_back(choice<Value>(one));
    });
    owner.leave_my_subsection(prm);
  }
} // namespace Heddle

#endif
