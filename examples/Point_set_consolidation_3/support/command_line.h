// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_COMMAND_LINE_H
#define CONSOLIDATION_SUPPORT_COMMAND_LINE_H

#include "types.h"

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace support {

/// Wrong command line; the message names the option. Programs exit with status 1.
struct Usage_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A program's options, each bound to a variable that holds its default until `parse()`:
///
///     double omega = 45;
///     std::optional<std::size_t> particles;
///     std::vector<Vec3> scanners;
///     Command_line command_line("consolidate_point_set", "Consolidates and completes a scan.");
///     command_line.positional("INPUT", input, "point file");
///     command_line.option("--omega", "DEG", omega, "collision angle").between(0, 180);
///     command_line.option("--particles", "N", particles, "number of particles").at_least(10);
///     command_line.option("--scanner", "X Y Z", scanners, "scanner position; may be repeated");
///     command_line.flag("-q,--quiet", quiet, "no progress bar");
///     if(!command_line.parse(argc, argv))
///       return;  // --help or --version
///
/// The type of the variable says what is accepted: a `std::string`, a floating point number, an
/// integer or a `Vec3` (three numbers); `std::optional` of these if there is no default, and
/// `std::vector` of these if the option may be repeated. `--name=value` is understood as well, and
/// `--` ends the options.
class Command_line {
public:
  class Option {
  public:
    Option& at_least(double least);
    Option& above(double bound);  ///< the bound itself is not allowed
    Option& between(double least, double most);
    Option& one_of(const std::vector<std::string>& words);
    /// What --help says of the default, where the variable cannot say it.
    Option& default_is(const std::string& text);

  private:
    friend class Command_line;
    using Words = std::vector<std::string>;

    double number(const std::string& word) const;
    double whole_number(const std::string& word, double least, double most) const;
    const std::string& checked_word(const std::string& word) const;
    [[noreturn]] void error(const std::string& message) const;

    Words names;        // the long name last; the name of a positional argument
    Words value_names;  // one for each word of the value
    std::string help;
    std::string default_text;
    bool is_repeatable = false;
    bool was_given = false;
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool least_is_allowed = true;
    std::vector<std::string> allowed_words;
    std::function<void(const Option&, const Words&)> set;
    std::string heading;  // printed above it in the help
  };

  Command_line(const std::string& program, const std::string& purpose);

  /// A required argument without a name, in the order of these calls.
  void positional(const std::string& name, std::string& value, const std::string& help);

  /// Begins a group of options in the help.
  void heading(const std::string& text) { m_next_heading = text; }

  /// `names` as in "-o,--output"; `value_names` is a word for each word of the value, a unit where
  /// there is one.
  template <typename T>
  Option& option(const std::string& names, const std::string& value_names, T& value,
                 const std::string& help)
  {
    Option& option = add(names, value_names, help);
    option.default_text = text_of(value);
    option.is_repeatable = Is_vector<T>::value;
    option.set = [&value](const Option& self, const Words& words) { assign(value, self, words); };
    return option;
  }

  /// An option without a value that sets `value` to true.
  Option& flag(const std::string& names, bool& value, const std::string& help);

  /// False if the program is to end because --help or --version was asked for and printed.
  /// \throws Usage_error
  bool parse(int argc, const char* const* argv);

  std::string help() const;

private:
  using Words = Option::Words;

  template <typename T>
  struct Is_vector : std::false_type {};
  template <typename T>
  struct Is_vector<std::vector<T>> : std::true_type {};

  template <typename T>
  static void assign(T& value, const Option& option, const Words& words)
  {
    if constexpr(std::is_floating_point_v<T>)
      value = static_cast<T>(option.number(words[0]));
    else if constexpr(std::is_integral_v<T>)
      value = static_cast<T>(
          option.whole_number(words[0], static_cast<double>(std::numeric_limits<T>::min()),
                              static_cast<double>(std::numeric_limits<T>::max())));
    else
      value = T(option.checked_word(words[0]));
  }
  static void assign(Vec3& value, const Option& option, const Words& words)
  {
    for(int i = 0; i < 3; ++i)
      value[i] = option.number(words[static_cast<std::size_t>(i)]);
  }
  template <typename T>
  static void assign(std::optional<T>& value, const Option& option, const Words& words)
  {
    assign(value.emplace(), option, words);
  }
  template <typename T>
  static void assign(std::vector<T>& values, const Option& option, const Words& words)
  {
    assign(values.emplace_back(), option, words);
  }

  static std::string number_text(double value);
  template <typename T>
  static std::string text_of(const T& value)
  {
    if constexpr(std::is_arithmetic_v<T>)
      return number_text(static_cast<double>(value));
    else if constexpr(std::is_convertible_v<T, std::string>)
      return value;
    else
      return {};
  }

  Option& add(const std::string& names, const std::string& value_names, const std::string& help);
  Option& find(const std::string& name);

  std::string m_program;
  std::string m_purpose;
  std::string m_next_heading;
  std::deque<Option> m_options;  // references to them stay valid
  std::deque<Option> m_positionals;
  bool m_wants_help = false;
  bool m_wants_version = false;
};

/// Runs a program's body and returns its exit status: 0, or after one line on the standard error
/// output that begins with the program's name, 1 for a `Usage_error`, 2 for a `File_error`, 3 for
/// anything else that was thrown.
int run_program(const std::string& name, const std::function<void()>& body) noexcept;

/// `work()`, on points from a file. A `std::invalid_argument`, which functions throw if they cannot work with the
/// points, becomes a `File_error` of that file; where there is no result, the message names the file as well.
template <typename Work>
auto with_points_of(const std::string& file, const Work& work)
{
  try {
    return work();
  }
  catch(const std::invalid_argument& error) {
    throw File_error(file + ": " + error.what());
  }
  catch(const File_error&) {  // of another file
    throw;
  }
  catch(const Usage_error&) {
    throw;
  }
  catch(const std::runtime_error& error) {
    throw Method_error(file + ": " + error.what());
  }
}

/// Says on the standard error output which files were written, unless `is_quiet`. Empty names are skipped.
void report_files(bool is_quiet, const std::vector<std::string>& files);

/// A bar on the standard error output, if that is a terminal and `is_quiet` is false. As a callback
/// of CGAL it is passed as `std::ref(bar)`; it never cancels.
class Progress_bar {
public:
  explicit Progress_bar(const std::string& label, bool is_quiet = false);
  ~Progress_bar();  ///< wipes the bar
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  bool operator()(double fraction);

private:
  std::string m_label;
  bool m_is_shown = false;
  bool m_was_drawn = false;
  std::chrono::steady_clock::time_point m_last_time;
};

/// Limits the number of threads of parallel algorithms as long as it lives; 0 is no limit.
class Thread_limit {
public:
  explicit Thread_limit(std::size_t number_of_threads);
  ~Thread_limit();
  Thread_limit(const Thread_limit&) = delete;
  Thread_limit& operator=(const Thread_limit&) = delete;

private:
  struct Control;
  std::unique_ptr<Control> m_control;
};

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_COMMAND_LINE_H
