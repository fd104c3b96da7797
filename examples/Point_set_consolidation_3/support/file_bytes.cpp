// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "file_bytes.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include <unistd.h>

namespace support {

namespace fs = std::filesystem;

namespace {

struct Close {
  void operator()(std::FILE* stream) const { std::fclose(stream); }
};
using Stream = std::unique_ptr<std::FILE, Close>;

bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

void skip_blanks(std::string_view& text)
{
  std::size_t i = 0;
  while(i < text.size() && is_blank(text[i]))
    ++i;
  text.remove_prefix(i);
}

/// Writes and closes. The close is part of it: a full disk may show only then.
bool write_all(Stream stream, std::string_view bytes)
{
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), stream.get()) == bytes.size();
  return std::fclose(stream.release()) == 0 && written;
}

}  // namespace

void file_error(const std::string& file, const std::string& message)
{
  throw File_error(file + ": " + message);
}

std::string read_file(const std::string& file)
{
  std::error_code ignored;
  if(fs::is_directory(file, ignored))
    file_error(file, "is a folder");
  Stream stream(std::fopen(file.c_str(), "rb"));
  if(!stream)
    file_error(file, std::string("cannot be opened: ") + std::strerror(errno));

  std::string bytes;
  char block[1 << 16];
  while(const std::size_t n = std::fread(block, 1, sizeof block, stream.get()))
    bytes.append(block, n);
  if(std::ferror(stream.get()))
    file_error(file, std::string("cannot be read: ") + std::strerror(errno));
  if(bytes.empty())
    file_error(file, "is empty");
  return bytes;
}

void replace_file(const std::string& file, const std::function<bool(const std::string&)>& write)
{
  std::error_code ignored;
  const fs::path target
      = fs::is_symlink(file, ignored) ? fs::weakly_canonical(file, ignored) : fs::path(file);
  const bool is_special = fs::exists(target, ignored) && !fs::is_regular_file(target, ignored);
  if(fs::is_directory(target, ignored))
    file_error(file, "cannot be written: is a folder");

  const fs::path beside = is_special ? target
                                     : target.parent_path() / ("part" + std::to_string(::getpid()) + "_"
                                                               + target.filename().string());
  errno = 0;
  bool done = write(beside.string());
  if(done && !is_special)
    done = std::rename(beside.c_str(), target.c_str()) == 0;
  if(!done) {
    const int reason = errno;
    if(!is_special)
      std::remove(beside.c_str());
    file_error(file, std::string("cannot be written") + (reason == 0 ? "" : ": ")
                         + (reason == 0 ? "" : std::strerror(reason)));
  }
}

void write_file(const std::string& file, std::string_view bytes)
{
  replace_file(file, [bytes](const std::string& name) {
    Stream stream(std::fopen(name.c_str(), "wb"));
    return stream && write_all(std::move(stream), bytes);
  });
}

std::string extension(const std::string& file)
{
  std::string text = fs::path(file).extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

void check_extension(const std::string& file, std::initializer_list<const char*> known)
{
  const std::string given = extension(file);
  std::string list;
  for(const char* one : known) {
    if(given == one)
      return;
    list += (list.empty() ? "" : " ") + std::string(one);
  }
  file_error(
      file, (given.empty() ? std::string("has no extension") : "has the unknown extension " + given)
                + " (known: " + list + ")");
}

void check_output(const std::string& file, std::initializer_list<const char*> known)
{
  if(file.empty())
    return;
  if(known.size() > 0)
    check_extension(file, known);
  const fs::path folder = fs::path(file).parent_path();
  std::error_code ignored;
  if(!folder.empty() && !fs::is_directory(folder, ignored))
    file_error(file, "cannot be written: there is no folder " + folder.string());
}

void check_distinct(std::initializer_list<std::string> outputs)
{
  for(auto one = outputs.begin(); one != outputs.end(); ++one)
    for(auto other = outputs.begin(); other != one; ++other) {
      std::error_code ignored;
      const auto place = [&](const std::string& file) { return fs::weakly_canonical(file, ignored); };
      const bool is_device = fs::is_character_file(*one, ignored) || fs::is_fifo(*one, ignored);
      if(!one->empty() && !other->empty() && !is_device && place(*one) == place(*other))
        file_error(*one, "is named as the file of two outputs");
    }
}

void check_finite(const std::string& file, const std::vector<Vec3>& points)
{
  const auto is_bad = [](const Vec3& p) { return !p.allFinite(); };
  const auto first = std::find_if(points.begin(), points.end(), is_bad);
  if(first == points.end())
    return;
  const auto count = std::count_if(first, points.end(), is_bad);
  file_error(file, std::to_string(count) + (count == 1 ? " point has" : " points have")
                       + " coordinates that are not finite, the first is number "
                       + std::to_string(first - points.begin()) + " (counted from 0)");
}

Text_scanner::Text_scanner(std::string_view text) : m_rest(text) {}

bool Text_scanner::next_line()
{
  while(!m_rest.empty()) {
    const std::size_t end = m_rest.find('\n');
    m_line = m_rest.substr(0, end);
    m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
    ++m_line_number;
    m_line = m_line.substr(0, m_line.find('#'));
    if(!at_end_of_line())
      return true;
  }
  m_line = {};
  return false;
}

bool Text_scanner::at_end_of_line()
{
  skip_blanks(m_line);
  return m_line.empty();
}

bool Text_scanner::number(double& value)
{
  skip_blanks(m_line);
  std::string_view text = m_line;
  if(!text.empty() && text.front() == '+')  // from_chars() does not know the sign
    text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if(error == std::errc::invalid_argument)
    return false;
  const std::size_t length = static_cast<std::size_t>(end - text.data());
  if(length < text.size() && !is_blank(text[length]))
    return false;
  if(error == std::errc::result_out_of_range)  // zero or infinity, which from_chars() leaves open
    value = std::strtod(std::string(text.substr(0, length)).c_str(), nullptr);
  m_line = text.substr(length);
  return true;
}

std::string_view Text_scanner::word()
{
  skip_blanks(m_line);
  const std::size_t length = static_cast<std::size_t>(
      std::find_if(m_line.begin(), m_line.end(), is_blank) - m_line.begin());
  const std::string_view result = m_line.substr(0, length);
  m_line.remove_prefix(length);
  return result;
}

void append_number(std::string& text, double value)
{
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  (void)error;  // 32 characters hold every double
  text.append(digits, end);
}

}  // namespace support
