// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_FILE_BYTES_H
#define CONSOLIDATION_SUPPORT_FILE_BYTES_H

#include "types.h"

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace support {

/// Throws `File_error` with the one-line message "FILE: MESSAGE".
[[noreturn]] void file_error(const std::string& file, const std::string& message);

/// The whole file. \throws File_error with the system's reason, also if it is a folder or empty.
std::string read_file(const std::string& file);

/// `write(name)` writes a file and says whether it could. The name is one beside `file`, with its extension; what
/// was written is renamed to `file`, so that there is either the whole file or none of it, and what was there before
/// is kept if anything fails. A device or pipe is written to directly, and a symbolic link is followed.
/// \throws File_error with the system's reason.
void replace_file(const std::string& file, const std::function<bool(const std::string&)>& write);

/// The bytes as a file, by `replace_file()`.
void write_file(const std::string& file, std::string_view bytes);

/// The extension in lower case with its dot, ".ply"; empty if there is none.
std::string extension(const std::string& file);

/// \throws File_error if the extension is none of `known`; the message lists them.
void check_extension(const std::string& file, std::initializer_list<const char*> known);

/// Before long work whose result goes into `file`; an empty name is an output that is not wanted. No `known`: any
/// extension.
/// \throws File_error if the extension is none of `known`, or the folder does not exist.
void check_output(const std::string& file, std::initializer_list<const char*> known = {});

/// \throws File_error if two of the outputs are the same file; empty names are none.
void check_distinct(std::initializer_list<std::string> outputs);

/// \throws File_error if a coordinate is not finite; the message counts the points.
void check_finite(const std::string& file, const std::vector<Vec3>& points);

/// Takes numbers and lines from text, without a look at the locale.
class Text_scanner {
public:
  explicit Text_scanner(std::string_view text);

  /// Goes to the next line that is neither empty nor a comment; false at the end.
  bool next_line();

  std::string_view line() const { return m_line; }           ///< what is left of the current line
  std::size_t line_number() const { return m_line_number; }  ///< from 1

  /// The next number of the current line; false if the line is at its end or goes on with
  /// something that is not a number (then `at_end_of_line()` is false).
  bool number(double& value);

  /// The next word of the current line; empty at its end.
  std::string_view word();

  bool at_end_of_line();

private:
  std::string_view m_rest;
  std::string_view m_line;
  std::size_t m_line_number = 0;
};

/// Appends a number to text with as many digits as are needed to read the same number again.
void append_number(std::string& text, double value);

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_FILE_BYTES_H
