// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ply_file.h"

#include "file_bytes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace support {

namespace {

enum class Format { ascii, little_endian, big_endian };

struct Type_names {
  const char* name;
  const char* sized_name;
  std::size_t bytes;
};

// in the order of Ply_type
constexpr std::array<Type_names, 8> type_names{{{"char", "int8", 1},
                                                {"uchar", "uint8", 1},
                                                {"short", "int16", 2},
                                                {"ushort", "uint16", 2},
                                                {"int", "int32", 4},
                                                {"uint", "uint32", 4},
                                                {"float", "float32", 4},
                                                {"double", "float64", 8}}};

const Type_names& names_of(Ply_type type)
{
  return type_names[static_cast<std::size_t>(type)];
}

bool is_floating(Ply_type type)
{
  return type == Ply_type::float32 || type == Ply_type::float64;
}

bool machine_is_little_endian()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

template <typename T>
double value_of(const char* bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

template <typename T>
void bytes_of(double value, char* bytes)
{
  const T typed = static_cast<T>(value);
  std::memcpy(bytes, &typed, sizeof typed);
}

double decode(Ply_type type, const char* bytes)
{
  switch(type) {
    case Ply_type::int8: return value_of<std::int8_t>(bytes);
    case Ply_type::uint8: return value_of<std::uint8_t>(bytes);
    case Ply_type::int16: return value_of<std::int16_t>(bytes);
    case Ply_type::uint16: return value_of<std::uint16_t>(bytes);
    case Ply_type::int32: return value_of<std::int32_t>(bytes);
    case Ply_type::uint32: return value_of<std::uint32_t>(bytes);
    case Ply_type::float32: return value_of<float>(bytes);
    case Ply_type::float64: break;
  }
  return value_of<double>(bytes);
}

void encode(Ply_type type, double value, char* bytes)
{
  switch(type) {
    case Ply_type::int8: return bytes_of<std::int8_t>(value, bytes);
    case Ply_type::uint8: return bytes_of<std::uint8_t>(value, bytes);
    case Ply_type::int16: return bytes_of<std::int16_t>(value, bytes);
    case Ply_type::uint16: return bytes_of<std::uint16_t>(value, bytes);
    case Ply_type::int32: return bytes_of<std::int32_t>(value, bytes);
    case Ply_type::uint32: return bytes_of<std::uint32_t>(value, bytes);
    case Ply_type::float32: return bytes_of<float>(value, bytes);
    case Ply_type::float64: return bytes_of<double>(value, bytes);
  }
}

class Reader {
public:
  explicit Reader(const std::string& file) : m_file(file), m_bytes(read_file(file)), m_rest(m_bytes)
  {}

  Ply_file read()
  {
    Ply_file ply = read_header();
    std::size_t smallest_item = 1;
    for(Ply_element& element : ply.elements) {
      if(element.properties.empty() && element.count > 0)
        file_error(m_file, "the PLY header gives '" + element.name + "' no properties");
      smallest_item = check_count(element);
      read_items(element);
    }
    check_end(smallest_item);
    return ply;
  }

private:
  std::string header_line()
  {
    const std::size_t end = m_rest.find('\n');
    if(end == std::string_view::npos)
      file_error(m_file, "the PLY header has no end");
    std::string line(m_rest.substr(0, end));
    m_rest.remove_prefix(end + 1);
    if(!line.empty() && line.back() == '\r')
      line.pop_back();
    ++m_line_number;
    return line;
  }

  [[noreturn]] void header_error() const
  {
    file_error(m_file,
               "line " + std::to_string(m_line_number) + " of the PLY header is not understood");
  }

  Ply_type type(std::string_view word) const
  {
    for(std::size_t i = 0; i < type_names.size(); ++i)
      if(word == type_names[i].name || word == type_names[i].sized_name)
        return static_cast<Ply_type>(i);
    header_error();
  }

  Ply_file read_header()
  {
    if(m_rest.substr(0, 3) != "ply")
      file_error(m_file, "is not a PLY file: it does not begin with 'ply'");
    header_line();
    Ply_file ply;
    bool has_format = false;
    for(;;) {
      const std::string line = header_line();
      Text_scanner scanner(line);
      if(!scanner.next_line())
        continue;
      const std::string_view keyword = scanner.word();
      if(keyword == "end_header")
        break;
      if(keyword == "comment" || keyword == "obj_info")
        continue;
      if(keyword == "format") {
        const std::string_view name = scanner.word();
        if(name == "ascii")
          m_format = Format::ascii;
        else if(name == "binary_little_endian")
          m_format = Format::little_endian;
        else if(name == "binary_big_endian")
          m_format = Format::big_endian;
        else
          header_error();
        has_format = true;
      } else if(keyword == "element") {
        Ply_element element;
        element.name = scanner.word();
        double count = -1;
        if(element.name.empty() || !scanner.number(count) || !(count >= 0 && count < 1e15)
           || count != static_cast<double>(static_cast<std::size_t>(count)))
          header_error();
        element.count = static_cast<std::size_t>(count);
        ply.elements.push_back(element);
      } else if(keyword == "property" && !ply.elements.empty()) {
        Ply_property property;
        std::string_view word = scanner.word();
        if(word == "list") {
          property.is_list = true;
          property.size_type = type(scanner.word());
          if(is_floating(property.size_type))
            header_error();
          word = scanner.word();
        }
        property.type = type(word);
        property.name = scanner.word();
        if(property.name.empty())
          header_error();
        ply.elements.back().properties.push_back(property);
      } else {
        header_error();
      }
    }
    if(!has_format)
      file_error(m_file, "the PLY header names no format");
    return ply;
  }

  /// Bytes of the smallest possible item, after a check that the file can hold as many as the
  /// header says.
  std::size_t check_count(const Ply_element& element) const
  {
    std::size_t smallest = 0;
    for(const Ply_property& property : element.properties)
      smallest += m_format == Format::ascii  // a digit and a blank
                      ? 2
                      : names_of(property.is_list ? property.size_type : property.type).bytes;
    // the blank after the last number of a text file may be missing
    const std::size_t available = m_rest.size() + (m_format == Format::ascii ? 1 : 0);
    if(smallest > 0 && element.count > available / smallest)
      truncated(element, available / smallest);
    return (std::max)(smallest, std::size_t(1));
  }

  [[noreturn]] void truncated(const Ply_element& element, std::size_t at_most) const
  {
    file_error(m_file, "is truncated: the header says " + std::to_string(element.count)
                           + " items of '" + element.name + "', the file holds at most "
                           + std::to_string(at_most));
  }

  void read_items(Ply_element& element)
  {
    for(Ply_property& property : element.properties) {
      property.values.reserve(element.count);
      if(property.is_list)
        property.list_ends.reserve(element.count);
    }
    for(std::size_t i = 0; i < element.count; ++i)
      for(Ply_property& property : element.properties) {
        std::size_t length = 1;
        if(property.is_list)
          length = read_list_length(property, element, i);
        for(std::size_t j = 0; j < length; ++j)
          property.values.push_back(read_number(property.type, element, i));
        if(property.is_list)
          property.list_ends.push_back(property.values.size());
      }
  }

  std::size_t read_list_length(const Ply_property& property, const Ply_element& element,
                               std::size_t item)
  {
    const double length = read_number(property.size_type, element, item);
    if(!(length >= 0 && length <= static_cast<double>(m_bytes.size()))) {
      std::string message = "item " + std::to_string(item) + " of '" + element.name + "' has a list of ";
      append_number(message, length);
      file_error(m_file, message + " values");
    }
    return static_cast<std::size_t>(length);
  }

  double read_number(Ply_type type, const Ply_element& element, std::size_t item)
  {
    if(m_format == Format::ascii)
      return read_text_number(element, item);
    const std::size_t size = names_of(type).bytes;
    if(m_rest.size() < size)
      truncated(element, item);
    char bytes[8];
    std::memcpy(bytes, m_rest.data(), size);
    m_rest.remove_prefix(size);
    if((m_format == Format::little_endian) != machine_is_little_endian())
      std::reverse(bytes, bytes + size);
    return decode(type, bytes);
  }

  /// Items are separated by any blanks, so that lines do not matter.
  double read_text_number(const Ply_element& element, std::size_t item)
  {
    double value = 0;
    while(m_text.at_end_of_line())
      if(!next_text_line())
        truncated(element, item);
    if(!m_text.number(value))
      file_error(m_file, "item " + std::to_string(item) + " of '" + element.name
                             + "' holds something that is not a number");
    return value;
  }

  bool next_text_line()
  {
    if(m_rest.empty())
      return false;
    const std::size_t end = m_rest.find('\n');
    m_text = Text_scanner(m_rest.substr(0, end));
    m_text.next_line();
    m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
    return true;
  }

  /// A header that says less than there is lies as well; a few bytes of padding are harmless.
  void check_end(std::size_t smallest_item)
  {
    bool has_more = m_rest.size() >= (std::max)(smallest_item, std::size_t(8));
    if(m_format == Format::ascii) {
      has_more = !m_text.at_end_of_line();
      while(!has_more && next_text_line())
        has_more = !m_text.at_end_of_line();
    }
    if(has_more)
      file_error(m_file, "holds more data than its header says");
  }

  const std::string& m_file;
  const std::string m_bytes;
  std::string_view m_rest;
  Text_scanner m_text{std::string_view()};
  Format m_format = Format::ascii;
  std::size_t m_line_number = 0;
};

void append(std::string& bytes, Ply_type type, double value)
{
  char encoded[8];
  encode(type, value, encoded);
  const std::size_t size = names_of(type).bytes;
  if(!machine_is_little_endian())
    std::reverse(encoded, encoded + size);
  bytes.append(encoded, size);
}

}  // namespace

const Ply_property* Ply_element::find_number(const std::string& property) const
{
  for(const Ply_property& candidate : properties)
    if(candidate.name == property && !candidate.is_list)
      return &candidate;
  return nullptr;
}

const Ply_property* Ply_element::find_list(const std::string& property) const
{
  for(const Ply_property& candidate : properties)
    if(candidate.name == property && candidate.is_list)
      return &candidate;
  return nullptr;
}

const Ply_element* Ply_file::find(const std::string& element) const
{
  for(const Ply_element& candidate : elements)
    if(candidate.name == element)
      return &candidate;
  return nullptr;
}

Ply_file read_ply(const std::string& file)
{
  return Reader(file).read();
}

void write_ply(const std::string& file, const Ply_file& ply)
{
  std::string bytes = "ply\nformat binary_little_endian 1.0\n";
  for(const Ply_element& element : ply.elements) {
    bytes += "element " + element.name + " " + std::to_string(element.count) + "\n";
    for(const Ply_property& property : element.properties) {
      bytes += "property ";
      if(property.is_list)
        bytes += std::string("list ") + names_of(property.size_type).name + " ";
      bytes += std::string(names_of(property.type).name) + " " + property.name + "\n";
    }
  }
  bytes += "end_header\n";

  for(const Ply_element& element : ply.elements)
    for(std::size_t i = 0; i < element.count; ++i)
      for(const Ply_property& property : element.properties) {
        std::size_t begin = i, end = i + 1;
        if(property.is_list) {
          begin = i == 0 ? 0 : property.list_ends[i - 1];
          end = property.list_ends[i];
          append(bytes, property.size_type, static_cast<double>(end - begin));
        }
        for(std::size_t j = begin; j < end; ++j)
          append(bytes, property.type, property.values[j]);
      }
  write_file(file, bytes);
}

bool has_vectors(const Ply_element& element, const Vector_names& names)
{
  return std::all_of(names.begin(), names.end(),
                     [&](const char* name) { return element.find_number(name) != nullptr; });
}

std::vector<Vec3> read_vectors(const Ply_element& element, const Vector_names& names)
{
  std::vector<Vec3> result(element.count);
  for(int i = 0; i < 3; ++i) {
    const Ply_property* column = element.find_number(names[static_cast<std::size_t>(i)]);
    for(std::size_t j = 0; j < element.count; ++j)
      result[j][i] = column->values[j];
  }
  return result;
}

void append_vectors(Ply_element& element, const Vector_names& names, Ply_type type,
                    const std::vector<Vec3>& vectors)
{
  for(int i = 0; i < 3; ++i) {
    Ply_property column{names[static_cast<std::size_t>(i)], type};
    column.values.reserve(vectors.size());
    for(const Vec3& v : vectors)
      column.values.push_back(v[i]);
    element.properties.push_back(std::move(column));
  }
}

const Ply_element& vertex_element(const std::string& file, const Ply_file& ply)
{
  const Ply_element* vertex = ply.find("vertex");
  if(!vertex)
    vertex = ply.find("vertices");
  if(!vertex)
    file_error(file, "has no PLY element 'vertex'");
  if(!has_vectors(*vertex, position_names))
    file_error(file, "the PLY element 'vertex' lacks x, y or z");
  return *vertex;
}

}  // namespace support
