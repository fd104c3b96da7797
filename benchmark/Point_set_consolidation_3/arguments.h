// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_ARGUMENTS_H
#define CONSOLIDATION_BENCHMARK_ARGUMENTS_H

#include "types.h"

#include <cstdlib>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmark {

/// Wrong command line; programs exit with status 1.
struct Usage_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// `program FILE... --name value --flag`, with the known names given up front.
class Arguments {
public:
  Arguments(int argc, char** argv, const std::set<std::string>& with_value,
            const std::set<std::string>& flags)
  {
    for(int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if(with_value.count(word)) {
        if(i + 1 == argc)
          throw Usage_error(word + " needs a value");
        m_values[word] = argv[++i];
      } else if(flags.count(word) || word == "--help") {
        m_flags.insert(word);
      } else if(word.size() > 1 && word[0] == '-') {
        throw Usage_error("unknown option " + word);
      } else {
        m_files.push_back(word);
      }
    }
  }

  const std::vector<std::string>& files() const { return m_files; }
  bool has(const std::string& name) const { return m_flags.count(name) || m_values.count(name); }

  std::string text(const std::string& name, const std::string& fallback = "") const
  {
    const auto found = m_values.find(name);
    return found == m_values.end() ? fallback : found->second;
  }

  double number(const std::string& name, double fallback) const
  {
    const auto found = m_values.find(name);
    if(found == m_values.end())
      return fallback;
    char* end = nullptr;
    const double value = std::strtod(found->second.c_str(), &end);
    if(found->second.empty() || *end != '\0')
      throw Usage_error(name + " needs a number, not '" + found->second + "'");
    return value;
  }

  std::size_t count(const std::string& name, std::size_t fallback) const
  {
    const double value = number(name, static_cast<double>(fallback));
    if(value < 0 || value != static_cast<double>(static_cast<std::size_t>(value))) {
      throw Usage_error(name + " needs a whole number");
    }
    return static_cast<std::size_t>(value);
  }

  /// comma separated words
  std::vector<std::string> list(const std::string& name,
                                const std::vector<std::string>& fallback = {}) const
  {
    const auto found = m_values.find(name);
    if(found == m_values.end())
      return fallback;
    std::vector<std::string> words;
    std::istringstream stream(found->second);
    for(std::string word; std::getline(stream, word, ',');) {
      if(!word.empty())
        words.push_back(word);
    }
    return words;
  }

private:
  std::vector<std::string> m_files;
  std::map<std::string, std::string> m_values;
  std::set<std::string> m_flags;
};

/// What every program here does with its command line. Exit status as for all programs of the package: 1 wrong
/// options, 2 a file, 3 no result.
template <typename Usage, typename Run>
int run_program(const char* name, const Usage& usage, int argc, char** argv,
                const std::set<std::string>& with_value, const std::set<std::string>& flags,
                const Run& run)
{
  try {
    const Arguments arguments(argc, argv, with_value, flags);
    if(arguments.has("--help"))
      std::cout << usage;
    else
      run(arguments);
    return 0;
  } catch(const Usage_error& error) {
    std::cerr << name << ": " << error.what() << " (see --help)\n";
    return 1;
  } catch(const support::File_error& error) {
    std::cerr << name << ": " << error.what() << "\n";
    return 2;
  } catch(const std::exception& error) {
    std::cerr << name << ": " << error.what() << "\n";
    return 3;
  }
}

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_ARGUMENTS_H
