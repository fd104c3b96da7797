// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stroke_font.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace support {
namespace {

/// In units of the glyphs' grid.
constexpr double cap_height = 6;
constexpr double baseline = 2;
constexpr double letter_gap = 1.7;
constexpr double space_width = 1.6;
constexpr double max_corner_radius = 2;

struct Glyph {
  char character;
  const char* strokes;
};

/// Strokes are separated by spaces. Each is a letter and two digits, x and y, per point: 's' for
/// straight lines, 'r' with rounded corners, 'c' rounded and closed. The baseline is at y = 2,
/// small letters end at 6, capital letters at 8, descenders at 0.
constexpr Glyph glyphs[] = {
    {'!', "s0804 s0202"},
    {'"', "s0806 s1816"},
    {'#', "s1218 s3238 s0444 s0646"},
    {'$', "r4748080545420203 s2921"},
    {'%', "s0248 c06262808 c22424424"},
    {'&', "r420608383604023244"},
    {'\'', "s0806"},
    {'(', "r19070311"},
    {')', "r09171301"},
    {'*', "s2824 s0745 s0547"},
    {'+', "s2327 s0545"},
    {',', "s1201"},
    {'-', "s0434"},
    {'.', "s0202"},
    {'/', "s0139"},
    {'0', "c02424808"},
    {'1', "s072822"},
    {'2', "r0708484502 s0242"},
    {'3', "r0708484525 r2545420203"},
    {'4', "s380444 s3832"},
    {'5', "s480805 r0546420203"},
    {'6', "c02424606 r04083847"},
    {'7', "s084812"},
    {'8', "c05454808 c02424505"},
    {'9', "c04444808 r46421203"},
    {':', "s0202 s0505"},
    {';', "s1515 s1201"},
    {'<', "s370533"},
    {'=', "s0444 s0646"},
    {'>', "s073503"},
    {'?', "r070848452524 s2222"},
    {'@', "c13333515 r35335358080252"},
    {'A', "s022842 s1434"},
    {'B', "s0802 s0828 r28484525 s2505 r25454222 s2202"},
    {'C', "r474808024243"},
    {'D', "s0802 s0828 r28484222 s2202"},
    {'E', "s48080242 s0535"},
    {'F', "s480802 s0535"},
    {'G', "r474808024245 s4525"},
    {'H', "s0802 s4842 s0545"},
    {'I', "s0802"},
    {'J', "r38320203"},
    {'K', "s0802 s4804 s1542"},
    {'L', "s080242"},
    {'M', "s0208254842"},
    {'N', "s02084248"},
    {'O', "c02424808"},
    {'P', "s0802 s0828 r28484525 s2505"},
    {'Q', "c02424808 s2451"},
    {'R', "s0802 s0828 r28484525 s2505 s2542"},
    {'S', "r4748080545420203"},
    {'T', "s0848 s2822"},
    {'U', "r08024248"},
    {'V', "s082248"},
    {'W', "s0812374258"},
    {'X', "s0842 s4802"},
    {'Y', "s082548 s2522"},
    {'Z', "s08480242"},
    {'[', "s19090111"},
    {'\\', "s0931"},
    {']', "s09191101"},
    {'^', "s062846"},
    {'_', "s0141"},
    {'`', "s0817"},
    {'a', "c02323606 s3632"},
    {'b', "s0802 c02323606"},
    {'c', "r353606023233"},
    {'d', "s3832 c02323606"},
    {'e', "s0434 r343606023233"},
    {'f', "r281812 s0626"},
    {'g', "c02323606 r36300001"},
    {'h', "s0802 r04063632"},
    {'i', "s0602 s0808"},
    {'j', "r161000 s1818"},
    {'k', "s0802 s3603 s1432"},
    {'l', "s0802"},
    {'m', "s0602 r04062622 r24264642"},
    {'n', "s0602 r04063632"},
    {'o', "c02323606"},
    {'p', "s0600 c02323606"},
    {'q', "s3630 c02323606"},
    {'r', "s0602 r040626"},
    {'s', "r3536060434320203"},
    {'t', "r181222 s0626"},
    {'u', "r06023234 s3632"},
    {'v', "s062246"},
    {'w', "s0612263246"},
    {'x', "s0632 s3602"},
    {'y', "s0622 s4610"},
    {'z', "s06360232"},
    {'{', "r29191505 r05151121"},
    {'|', "s0901"},
    {'}', "r09191525 r25151101"},
    {'~', "r04163446"},
};

using Xy = std::array<double, 2>;

Xy mix(const Xy& a, const Xy& b, double t)
{
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}

double distance(const Xy& a, const Xy& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Replaces the corner of a polyline by an arc that touches both legs, as far as `reach` from it.
void append_arc(const Xy& before, const Xy& corner, const Xy& after, double reach, Stroke& out)
{
  constexpr int steps = 6;
  constexpr double kappa = 0.5523;  // cubic that is closest to a quarter of a circle
  const Xy a = mix(corner, before, reach / distance(corner, before));
  const Xy d = mix(corner, after, reach / distance(corner, after));
  const Xy b = mix(a, corner, kappa), c = mix(d, corner, kappa);
  for(int i = 0; i <= steps; ++i) {
    const double t = double(i) / steps;
    const Xy ab = mix(a, b, t), bc = mix(b, c, t), cd = mix(c, d, t);
    out.push_back(mix(mix(ab, bc, t), mix(bc, cd, t), t));
  }
}

Stroke round_corners(const Stroke& corners, bool closed)
{
  Stroke out;
  const std::size_t n = corners.size();
  if(!closed)
    out.push_back(corners.front());
  for(std::size_t i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
    const Xy &before = corners[(i + n - 1) % n], &corner = corners[i],
             &after = corners[(i + 1) % n];
    // A leg between two corners is shared by both arcs.
    const double share_before = !closed && i == 1 ? 1 : 0.5;
    const double share_after = !closed && i + 2 == n ? 1 : 0.5;
    const double reach = std::min({max_corner_radius, share_before * distance(before, corner),
                                   share_after * distance(corner, after)});
    append_arc(before, corner, after, reach, out);
  }
  out.push_back(closed ? out.front() : corners.back());
  return out;
}

/// The strokes of one character on the grid; returns its width.
double append_glyph(char character, std::vector<Stroke>& strokes)
{
  if(character == ' ')
    return space_width;
  const auto is_wanted = [&](const Glyph& g) { return g.character == character; };
  auto glyph = std::find_if(std::begin(glyphs), std::end(glyphs), is_wanted);
  if(glyph == std::end(glyphs)) {
    character = '?';
    glyph = std::find_if(std::begin(glyphs), std::end(glyphs), is_wanted);
  }
  double width = 0;
  for(const char* c = glyph->strokes; *c != '\0';) {
    const char kind = *c++;
    Stroke corners;
    for(; *c != '\0' && *c != ' '; c += 2) {
      corners.push_back({double(c[0] - '0'), double(c[1] - '0')});
      width = std::max(width, corners.back()[0]);
    }
    if(*c == ' ')
      ++c;
    strokes.push_back(kind == 's' ? corners : round_corners(corners, kind == 'c'));
  }
  return width;
}

/// A glyph whose points lack a coordinate would be read beyond its end.
constexpr bool all_glyphs_are_well_formed()
{
  for(const Glyph& glyph : glyphs) {
    const char* c = glyph.strokes;
    while(*c != '\0') {
      if(*c != 's' && *c != 'r' && *c != 'c')
        return false;
      ++c;
      int digits = 0;
      for(; *c != '\0' && *c != ' '; ++c) {
        if(*c < '0' || *c > '9')
          return false;
        ++digits;
      }
      if(digits % 2 != 0 || digits < 4)
        return false;
      if(*c == ' ')
        ++c;
    }
  }
  return true;
}
static_assert(all_glyphs_are_well_formed());

}  // namespace

std::vector<Stroke> text_strokes(const std::string& text)
{
  std::vector<Stroke> line;
  double x = 0;
  for(char character : text) {
    std::vector<Stroke> strokes;
    const double width = append_glyph(character, strokes);
    for(Stroke& stroke : strokes) {
      for(Xy& p : stroke)
        p = {(x + p[0]) / cap_height, (p[1] - baseline) / cap_height};
      line.push_back(std::move(stroke));
    }
    x += width + letter_gap;
  }
  return line;
}

double text_width(const std::string& text)
{
  double x = 0;
  std::vector<Stroke> strokes;
  for(char character : text)
    x += append_glyph(character, strokes) + letter_gap;
  return std::max(0., x - letter_gap) / cap_height;
}

}  // namespace support
