// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "json.h"

#include "file_bytes.h"

#include <cmath>
#include <cstdio>

namespace support {

namespace {

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for(const char c : text) {
    if(c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if(static_cast<unsigned char>(c) < 0x20) {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned int>(c));
      result += code;
    } else {
      result += c;
    }
  }
  return result + '"';
}

}  // namespace

Json::Json(const std::string& text) : m_text(quoted(text)) {}

Json Json::object()
{
  Json result;
  result.m_kind = Kind::object;
  return result;
}

Json Json::array()
{
  Json result;
  result.m_kind = Kind::array;
  return result;
}

void Json::set_number(double value)
{
  if(!std::isfinite(value))
    return;
  m_text.clear();
  append_number(m_text, value);
}

Json& Json::operator[](const std::string& name)
{
  m_kind = Kind::object;
  for(auto& [known, value] : m_members)
    if(known == name)
      return value;
  m_members.emplace_back(name, Json());
  return m_members.back().second;
}

void Json::append(Json value)
{
  m_kind = Kind::array;
  m_members.emplace_back(std::string(), std::move(value));
}

void Json::print(std::string& text, const std::string& line_begin) const
{
  if(m_kind == Kind::scalar) {
    text += m_text;
    return;
  }
  const bool is_object = m_kind == Kind::object;
  text += is_object ? '{' : '[';
  bool is_first = true;
  for(const auto& [name, value] : m_members) {
    text += (is_first ? "" : ",") + line_begin + "  ";
    if(is_object)
      text += quoted(name) + ": ";
    value.print(text, line_begin + "  ");
    is_first = false;
  }
  if(!is_first)
    text += line_begin;
  text += is_object ? '}' : ']';
}

std::string Json::text() const
{
  std::string text;
  print(text, "\n");
  return text + '\n';
}

void write_json(const std::string& file, const Json& json)
{
  write_file(file, json.text());
}

}  // namespace support
