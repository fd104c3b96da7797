// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"

#include "file_bytes.h"

#include <CGAL/Point_set_consolidation_3/version.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include <unistd.h>

namespace support {

namespace {

constexpr std::size_t help_column = 28;  // where the explanations begin
constexpr std::size_t help_width = 100;

/// The parts between any of the separators, without empty ones.
std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while(begin <= text.size()) {
    const std::size_t end = (std::min)(text.find(separator, begin), text.size());
    if(end > begin)
      parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::string join(const std::vector<std::string>& parts, const std::string& separator)
{
  std::string text;
  for(const std::string& part : parts)
    text += (text.empty() ? "" : separator) + part;
  return text;
}

/// `left`, then `right` from `help_column` on, broken between words.
std::string help_entry(const std::string& left, const std::string& right)
{
  std::string text;
  std::string line = "  " + left;
  if(line.size() + 2 > help_column) {
    text += line + '\n';
    line.clear();
  }
  line.resize(help_column, ' ');
  bool is_empty = true;
  for(const std::string& word : split(right, ' ')) {
    if(!is_empty && line.size() + 1 + word.size() > help_width) {
      text += line + '\n';
      line.assign(help_column, ' ');
      is_empty = true;
    }
    line += (is_empty ? "" : " ") + word;
    is_empty = false;
  }
  return text + line + '\n';
}

std::string version()
{
  return std::to_string(CGAL_POINT_SET_CONSOLIDATION_3_VERSION_MAJOR) + '.'
         + std::to_string(CGAL_POINT_SET_CONSOLIDATION_3_VERSION_MINOR) + '.'
         + std::to_string(CGAL_POINT_SET_CONSOLIDATION_3_VERSION_PATCH);
}

}  // namespace

// ---- one option ----

Command_line::Option& Command_line::Option::at_least(double bound)
{
  least = bound;
  return *this;
}

Command_line::Option& Command_line::Option::above(double bound)
{
  least = bound;
  least_is_allowed = false;
  return *this;
}

Command_line::Option& Command_line::Option::between(double lower, double upper)
{
  least = lower;
  most = upper;
  return *this;
}

Command_line::Option& Command_line::Option::one_of(const std::vector<std::string>& words)
{
  allowed_words = words;
  return *this;
}

Command_line::Option& Command_line::Option::default_is(const std::string& text)
{
  default_text = text;
  return *this;
}

void Command_line::Option::error(const std::string& message) const
{
  throw Usage_error("option " + names.back() + ": " + message);
}

double Command_line::Option::number(const std::string& word) const
{
  Text_scanner scanner(word);
  double value = 0;
  if(!scanner.next_line() || !scanner.number(value) || !scanner.at_end_of_line()
     || !std::isfinite(value))
    error("'" + word + "' is not a number");
  if(value < least || value > most || (value == least && !least_is_allowed)) {
    if(std::isfinite(most))
      error(word + " is not between " + number_text(least) + " and " + number_text(most));
    error(word + " is not " + (least_is_allowed ? "at least " : "above ") + number_text(least));
  }
  return value;
}

double Command_line::Option::whole_number(const std::string& word, double lowest,
                                          double highest) const
{
  const double value = number(word);
  if(value != std::floor(value))
    error("'" + word + "' is not a whole number");
  // Doubles count exactly up to 2^53; the highest number of a larger type is rounded up to a power
  // of two that the type does not hold.
  const double exact = std::ldexp(1., 53);
  if(value < (std::max)(lowest, -exact) || value > (std::min)(highest, exact))
    error(word + (value < 0 ? " is too small" : " is too large"));
  return value;
}

const std::string& Command_line::Option::checked_word(const std::string& word) const
{
  if(!allowed_words.empty()
     && std::find(allowed_words.begin(), allowed_words.end(), word) == allowed_words.end())
    error("'" + word + "' is none of " + join(allowed_words, ", "));
  if(word.empty())
    error("the value is empty");
  return word;
}

// ---- all options ----

Command_line::Command_line(const std::string& program, const std::string& purpose)
  : m_program(program), m_purpose(purpose)
{}

Command_line::Option& Command_line::add(const std::string& names, const std::string& value_names,
                                        const std::string& help)
{
  Option& option = m_options.emplace_back();
  option.names = split(names, ',');
  option.value_names = split(value_names, ' ');
  option.help = help;
  option.heading = m_next_heading;
  m_next_heading.clear();
  return option;
}

void Command_line::positional(const std::string& name, std::string& value, const std::string& help)
{
  Option& option = m_positionals.emplace_back();
  option.names = {name};
  option.help = help;
  option.set = [&value](const Option&, const Words& words) { value = words[0]; };
}

Command_line::Option& Command_line::flag(const std::string& names, bool& value,
                                         const std::string& help)
{
  Option& option = add(names, "", help);
  option.set = [&value](const Option&, const Words&) { value = true; };
  return option;
}

Command_line::Option& Command_line::find(const std::string& name)
{
  for(Option& option : m_options)
    if(std::find(option.names.begin(), option.names.end(), name) != option.names.end())
      return option;
  throw Usage_error("unknown option " + name);
}

bool Command_line::parse(int argc, const char* const* argv)
{
  flag("-h,--help", m_wants_help, "prints this and ends");
  flag("--version", m_wants_version, "prints the version and ends");

  std::deque<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
  Words arguments;
  bool options_ended = false;
  while(!words.empty()) {
    std::string word = words.front();
    words.pop_front();
    if(options_ended || word.size() < 2 || word[0] != '-') {
      arguments.push_back(word);
      continue;
    }
    if(word == "--") {
      options_ended = true;
      continue;
    }
    const std::size_t equals = word.compare(0, 2, "--") == 0 ? word.find('=') : std::string::npos;
    if(equals != std::string::npos) {
      words.push_front(word.substr(equals + 1));
      word.resize(equals);
    }
    Option& option = find(word);
    if(option.value_names.empty() && equals != std::string::npos)
      option.error("takes no value");
    if(option.was_given && !option.is_repeatable)
      option.error("is given twice");
    option.was_given = true;
    const std::size_t count = option.value_names.size();
    if(words.size() < count)
      option.error("needs " + join(option.value_names, " "));
    const Words values(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count));
    words.erase(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count));
    option.set(option, values);
  }

  if(m_wants_help) {
    std::cout << help();
    return false;
  }
  if(m_wants_version) {
    std::cout << m_program << ' ' << version() << '\n';
    return false;
  }
  for(std::size_t i = 0; i < m_positionals.size(); ++i) {
    if(i >= arguments.size())
      throw Usage_error(m_positionals[i].names[0] + " is missing");
    m_positionals[i].set(m_positionals[i], {arguments[i]});
  }
  if(arguments.size() > m_positionals.size())
    throw Usage_error("unexpected argument '" + arguments[m_positionals.size()] + "'");
  return true;
}

std::string Command_line::help() const
{
  std::string text = "Usage: " + m_program;
  for(const Option& positional : m_positionals)
    text += ' ' + positional.names[0];
  text += " [options]\n" + m_purpose + "\n\n";
  for(const Option& positional : m_positionals)
    text += help_entry(positional.names[0], positional.help);
  for(const Option& option : m_options) {
    if(!option.heading.empty())
      text += '\n' + option.heading + '\n';
    std::string left = join(option.names, ", ");
    for(const std::string& value_name : option.value_names)
      left += ' ' + value_name;
    std::string right = option.help;
    if(!option.allowed_words.empty())
      right += ": " + join(option.allowed_words, " | ");
    if(!option.default_text.empty())
      right += " (default " + option.default_text + ")";
    text += help_entry(left, right);
  }
  return text;
}

std::string Command_line::number_text(double value)
{
  std::string text;
  append_number(text, value);
  return text;
}

// ---- programs ----

int run_program(const std::string& name, const std::function<void()>& body) noexcept
{
  const auto say = [&name](const std::string& message, int status) {
    std::string line = message.substr(0, message.find('\n'));
    std::cerr << name << ": " << line << '\n';
    return status;
  };
  try {
    body();
    return 0;
  } catch(const Usage_error& error) {
    return say(error.what() + std::string(" (see ") + name + " --help)", 1);
  } catch(const File_error& error) {
    return say(error.what(), 2);
  } catch(const std::bad_alloc&) {
    return say("not enough memory", 3);
  } catch(const std::exception& error) {
    return say(error.what(), 3);
  } catch(...) {
    return say("unknown failure", 3);
  }
}

// ---- progress ----

void report_files(bool is_quiet, const std::vector<std::string>& files)
{
  if(is_quiet)
    return;
  std::string line;
  for(const std::string& file : files)
    if(!file.empty())
      line += (line.empty() ? "wrote " : ", ") + file;
  if(!line.empty())
    std::fprintf(stderr, "%s\n", line.c_str());
}

Progress_bar::Progress_bar(const std::string& label, bool is_quiet)
  : m_label(label), m_is_shown(!is_quiet && ::isatty(STDERR_FILENO))
{}

Progress_bar::~Progress_bar()
{
  if(m_was_drawn)
    std::fprintf(stderr, "\r\033[K");
}

bool Progress_bar::operator()(double fraction)
{
  constexpr int width = 40;                        // characters of the bar
  constexpr std::chrono::milliseconds pause(100);  // more often is more than an eye can follow
  const auto now = std::chrono::steady_clock::now();
  if(!m_is_shown || (m_was_drawn && now - m_last_time < pause))
    return true;
  const double shown = (std::min)((std::max)(fraction, 0.), 1.);
  const int filled = static_cast<int>(shown * width);
  std::fprintf(stderr, "\r%s [%s%s] %3d %%", m_label.c_str(),
               std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(width - filled), ' ').c_str(),
               static_cast<int>(shown * 100));
  std::fflush(stderr);
  m_was_drawn = true;
  m_last_time = now;
  return true;
}

// ---- threads ----

#ifdef CGAL_LINKED_WITH_TBB

struct Thread_limit::Control {
  explicit Control(std::size_t number_of_threads)
    : control(tbb::global_control::max_allowed_parallelism, number_of_threads)
  {}
  tbb::global_control control;
};

Thread_limit::Thread_limit(std::size_t number_of_threads)
{
  if(number_of_threads > 0)
    m_control = std::make_unique<Control>(number_of_threads);
}

#else

struct Thread_limit::Control {};

Thread_limit::Thread_limit(std::size_t) {}

#endif

Thread_limit::~Thread_limit() = default;

}  // namespace support
