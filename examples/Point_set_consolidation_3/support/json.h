// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_JSON_H
#define CONSOLIDATION_SUPPORT_JSON_H

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace support {

/// A JSON value to write. Members keep the order in which they are named first:
///
///     Json report;
///     report["points"] = cloud.size();
///     report["seconds"]["sinking"] = 0.3;
///     report["stages"].append("sinking");
class Json {
public:
  Json() = default;  ///< null
  Json(const char* text) : Json(std::string(text)) {}
  Json(const std::string& text);

  /// Numbers that are not finite, which JSON does not know, become null.
  template <typename T, typename = std::enable_if_t<std::is_arithmetic_v<T>>>
  Json(T value)
  {
    if constexpr(std::is_same_v<T, bool>)
      m_text = value ? "true" : "false";
    else if constexpr(std::is_integral_v<T>)
      m_text = std::to_string(value);
    else
      set_number(static_cast<double>(value));
  }

  template <typename T>
  Json(const std::vector<T>& values) : m_kind(Kind::array)
  {
    for(const auto& value : values)
      append(value);
  }

  static Json object();  ///< without members so far
  static Json array();   ///< without values so far

  /// The member with that name, null if it is new. Makes this an object.
  Json& operator[](const std::string& name);
  /// Makes this an array.
  void append(Json value);

  /// One member or value per line, indented by two blanks per level.
  std::string text() const;

private:
  enum class Kind { scalar, array, object };

  void set_number(double value);
  void print(std::string& text, const std::string& line_begin) const;

  Kind m_kind = Kind::scalar;
  std::string m_text = "null";
  std::vector<std::pair<std::string, Json>> m_members;  // the names of an array's are empty
};

/// See `write_file()`. \throws File_error
void write_json(const std::string& file, const Json& json);

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_JSON_H
