// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plot.h"

#include "file_bytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace support {
namespace {

/// Told apart by lightness as well as by hue, for readers who see fewer hues.
constexpr std::array<const char*, 8> palette
    = {"#3b6ea5", "#e07b39", "#4f9d69", "#b23a48", "#7a5c99", "#c9a227", "#5fb3bf", "#5a5a5a"};
constexpr const char* ink = "#22242b";
constexpr const char* grid_color = "#dcdfe4";
constexpr double font_size = 13;
constexpr double character_width = 0.53 * font_size;  // on average, of common sans-serif fonts

/// Coordinates of the drawing need no more than hundredths of a pixel.
std::string coordinate(double v)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.2f", v);
  return text.data();
}

/// 1e4 rather than 1e+04.
std::string tick_text(double v)
{
  std::array<char, 32> digits;
  std::snprintf(digits.data(), digits.size(), "%.4g", v);
  std::string text = digits.data();
  const std::size_t e = text.find('e');
  if(e != std::string::npos) {
    if(text[e + 1] == '+')
      text.erase(e + 1, 1);
    const std::size_t first = text.find_first_of("123456789", e);
    const std::size_t begin = e + 1 + (text[e + 1] == '-' ? 1 : 0);
    text.erase(begin, first - begin);
  }
  return text;
}

std::string escape(const std::string& text)
{
  std::string out;
  for(char c : text) {
    if(c == '&')
      out += "&amp;";
    else if(c == '<')
      out += "&lt;";
    else if(c == '>')
      out += "&gt;";
    else if(c == '"')
      out += "&quot;";
    else if(static_cast<unsigned char>(c) >= ' ')
      out += c;
  }
  return out;
}

/// One direction of the diagram: from values to pixels.
class Axis {
public:
  Axis(bool logarithmic, bool from_zero) : m_log(logarithmic), m_from_zero(from_zero) {}

  bool shows(double v) const { return std::isfinite(v) && (!m_log || v > 0); }

  void include(double v)
  {
    if(shows(v)) {
      m_low = std::min(m_low, v);
      m_high = std::max(m_high, v);
    }
  }

  /// Chooses ticks, and widens the range to whole ones.
  void finish(bool widen)
  {
    if(!(m_low <= m_high)) {
      m_low = m_log ? 1 : 0;
      m_high = m_log ? 10 : 1;
    }
    if(m_log)
      choose_log_ticks();
    else
      choose_linear_ticks(widen);
  }

  void place(double low_pixel, double high_pixel)
  {
    m_low_pixel = low_pixel;
    m_high_pixel = high_pixel;
  }

  double pixel(double v) const
  {
    const double t
        = m_log ? std::log(v / m_low) / std::log(m_high / m_low) : (v - m_low) / (m_high - m_low);
    return m_low_pixel + t * (m_high_pixel - m_low_pixel);
  }

  const std::vector<double>& ticks() const { return m_ticks; }
  double low() const { return m_low; }

private:
  void choose_linear_ticks(bool widen)
  {
    constexpr double wanted = 6;
    if(m_from_zero && m_low > 0)
      m_low = 0;
    if(m_from_zero && m_high < 0)
      m_high = 0;
    if(m_low == m_high) {
      const double room = m_low == 0 ? 1 : 0.1 * std::abs(m_low);
      m_low -= m_from_zero && m_low == 0 ? 0 : room;
      m_high += room;
    }
    const double rough = (m_high - m_low) / wanted;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * power;
    for(double digit : {5., 2., 1.}) {
      if(digit * power >= rough)
        step = digit * power;
    }
    // A value on a tick must not be pushed beyond it by rounding.
    constexpr double slack = 1e-9;
    if(widen) {
      m_low = step * std::floor(m_low / step + slack);
      m_high = step * std::ceil(m_high / step - slack);
    }
    const double first = std::ceil(m_low / step - slack);
    for(double i = first; i * step <= m_high + slack * step; ++i)
      m_ticks.push_back(i == 0 ? 0 : i * step);  // no negative zero
  }

  void choose_log_ticks()
  {
    if(m_low == m_high) {
      m_low /= 2;
      m_high *= 2;
    }
    // The densest ticks that are not too many. They include those just beyond the range.
    constexpr std::size_t most = 9;
    const std::vector<std::vector<double>> choices = {{1, 2, 5}, {1, 3}, {1}};
    constexpr double slack = 1e-9;
    const double low = m_low * (1 + slack), high = m_high * (1 - slack);
    for(const std::vector<double>& digits : choices) {
      std::vector<double> candidates;
      for(double e = std::floor(std::log10(m_low)) - 1; e <= std::ceil(std::log10(m_high)) + 1;
          ++e) {
        for(double digit : digits)
          candidates.push_back(digit * std::pow(10, e));
      }
      auto first = std::upper_bound(candidates.begin(), candidates.end(), low);
      if(first != candidates.begin())
        --first;
      auto last = std::lower_bound(candidates.begin(), candidates.end(), high);
      if(last != candidates.end())
        ++last;
      m_ticks.assign(first, last);
      if(m_ticks.size() <= most)
        break;
    }
    m_low = std::min(m_low, m_ticks.front());
    m_high = std::max(m_high, m_ticks.back());
    const std::size_t step = 1 + (m_ticks.size() - 1) / most;
    std::size_t kept = 0;
    for(std::size_t i = 0; i < m_ticks.size(); i += step)
      m_ticks[kept++] = m_ticks[i];
    m_ticks.resize(kept);
  }

  bool m_log;
  bool m_from_zero;
  double m_low = std::numeric_limits<double>::infinity();
  double m_high = -std::numeric_limits<double>::infinity();
  double m_low_pixel = 0;
  double m_high_pixel = 1;
  std::vector<double> m_ticks;
};

/// SVG text under construction.
class Drawing {
public:
  Drawing(int width, int height)
  {
    m_svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(width)
            + "\" height=\"" + std::to_string(height) + "\" viewBox=\"0 0 " + std::to_string(width)
            + " " + std::to_string(height)
            + "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"" + coordinate(font_size)
            + "\">\n";
    rectangle(0, 0, width, height, "#ffffff");
  }

  void line(double x0, double y0, double x1, double y1, const std::string& color, double width)
  {
    m_svg += "<line x1=\"" + coordinate(x0) + "\" y1=\"" + coordinate(y0) + "\" x2=\""
             + coordinate(x1) + "\" y2=\"" + coordinate(y1) + "\" stroke=\"" + color
             + "\" stroke-width=\"" + coordinate(width) + "\"/>\n";
  }

  void polyline(const std::vector<std::array<double, 2>>& points, const std::string& color)
  {
    m_svg += "<polyline fill=\"none\" stroke-width=\"2\" stroke-linejoin=\"round\" stroke=\""
             + color + "\" points=\"";
    for(const auto& p : points)
      m_svg += coordinate(p[0]) + "," + coordinate(p[1]) + " ";
    m_svg.back() = '"';
    m_svg += "/>\n";
  }

  void mark(double x, double y, const std::string& color)
  {
    m_svg += "<circle r=\"3.2\" cx=\"" + coordinate(x) + "\" cy=\"" + coordinate(y) + "\" fill=\""
             + color + "\"/>\n";
  }

  void rectangle(double x, double y, double width, double height, const std::string& color)
  {
    m_svg += "<rect x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" width=\""
             + coordinate(width) + "\" height=\"" + coordinate(height) + "\" fill=\"" + color
             + "\"/>\n";
  }

  /// `anchor` is start, middle or end. `turn` is in degrees, clockwise.
  void text(double x, double y, const std::string& text, const std::string& anchor, double turn = 0,
            bool bold = false)
  {
    m_svg += "<text text-anchor=\"" + anchor + "\" fill=\"" + ink + "\" x=\"" + coordinate(x)
             + "\" y=\"" + coordinate(y) + "\"";
    if(turn != 0) {
      m_svg += " transform=\"rotate(" + coordinate(turn) + " " + coordinate(x) + " " + coordinate(y)
               + ")\"";
    }
    if(bold)
      m_svg += " font-weight=\"bold\"";
    m_svg += ">" + escape(text) + "</text>\n";
  }

  std::string finish() const { return m_svg + "</svg>\n"; }

private:
  std::string m_svg;
};

void check(const Plot& plot)
{
  for(const Series& s : plot.series) {
    const std::size_t expected = plot.categories.empty() ? s.x.size() : plot.categories.size();
    if(s.y.size() != expected) {
      throw std::invalid_argument("plot: series \"" + s.name + "\" has "
                                  + std::to_string(s.y.size()) + " values instead of "
                                  + std::to_string(expected));
    }
  }
}

double widest(const std::vector<std::string>& texts)
{
  std::size_t length = 0;
  for(const std::string& t : texts)
    length = std::max(length, t.size());
  return character_width * static_cast<double>(length);
}

void draw_line(const Series& series, const Axis& x, const Axis& y, const std::string& color,
               Drawing& drawing)
{
  std::vector<std::array<double, 2>> run;
  const auto end_run = [&] {
    if(run.size() > 1 && series.shape != Series::Shape::marks)
      drawing.polyline(run, color);
    if(series.shape != Series::Shape::line) {
      for(const auto& p : run)
        drawing.mark(p[0], p[1], color);
    }
    run.clear();
  };
  for(std::size_t i = 0; i < series.y.size(); ++i) {
    if(x.shows(series.x[i]) && y.shows(series.y[i]))
      run.push_back({x.pixel(series.x[i]), y.pixel(series.y[i])});
    else
      end_run();
  }
  end_run();
}

}  // namespace

Series cumulative_distribution(const std::string& name, std::vector<double> values)
{
  values.erase(
      std::remove_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }),
      values.end());
  std::sort(values.begin(), values.end());
  Series series;
  series.name = name;
  // A line of more points than pixels is only larger.
  constexpr std::size_t most_points = 500;
  const std::size_t n = values.size();
  const std::size_t steps = std::min(n, most_points);
  for(std::size_t k = 1; k <= steps; ++k) {
    const std::size_t rank = k * n / steps;  // values up to this one, from 1
    if(k == 1) {
      series.x.push_back(values.front());
      series.y.push_back(0);
    }
    series.x.push_back(values[rank - 1]);
    series.y.push_back(static_cast<double>(rank) / static_cast<double>(n));
  }
  return series;
}

std::string svg_of_plot(const Plot& plot)
{
  check(plot);
  const bool bars = !plot.categories.empty();
  Axis x(plot.log_x && !bars, false);
  Axis y(plot.log_y, bars || plot.y_from_zero);
  std::vector<std::string> names;
  for(const Series& s : plot.series) {
    for(double v : s.x)
      x.include(v);
    for(double v : s.y)
      y.include(v);
    names.push_back(s.name);
  }
  x.finish(false);
  y.finish(true);

  // Room for the texts around the diagram.
  std::vector<std::string> tick_texts;
  for(double v : y.ticks())
    tick_texts.push_back(tick_text(v));
  const bool has_legend
      = std::any_of(names.begin(), names.end(), [](const std::string& n) { return !n.empty(); });
  const double line_height = 1.5 * font_size;
  const double left = widest(tick_texts) + 14 + (plot.y_label.empty() ? 0 : line_height);
  const double legend_width = has_legend ? widest(names) + 40 : 0;
  const double right = plot.width - 14 - legend_width;
  const double top = plot.title.empty() ? 14 : 14 + line_height;
  const double slot = bars ? (right - left) / static_cast<double>(plot.categories.size()) : 0;
  // Names that do not fit beside each other are turned.
  const bool turned = bars && widest(plot.categories) > slot - 6;
  const double names_height = turned ? 0.71 * widest(plot.categories) + 8 : line_height;
  const double bottom = plot.height - 10 - names_height - (plot.x_label.empty() ? 0 : line_height);
  x.place(left, right);
  y.place(bottom, top);

  Drawing drawing(plot.width, plot.height);
  if(!plot.title.empty())
    drawing.text(0.5 * (left + right), 0.5 * top + 0.5 * font_size, plot.title, "middle", 0, true);
  for(std::size_t i = 0; i < y.ticks().size(); ++i) {
    const double at = y.pixel(y.ticks()[i]);
    drawing.line(left, at, right, at, grid_color, 1);
    drawing.text(left - 7, at + 0.35 * font_size, tick_texts[i], "end");
  }
  if(!bars) {
    for(double v : x.ticks()) {
      drawing.line(x.pixel(v), top, x.pixel(v), bottom, grid_color, 1);
      drawing.text(x.pixel(v), bottom + 1.3 * font_size, tick_text(v), "middle");
    }
  }

  const double base = y.pixel(plot.log_y ? y.low() : std::max(0., y.low()));
  for(std::size_t k = 0; k < plot.series.size(); ++k) {
    const std::string color = palette[k % palette.size()];
    if(!bars) {
      draw_line(plot.series[k], x, y, color, drawing);
      continue;
    }
    constexpr double filled = 0.8;  // of a category's slot
    const double width = filled * slot / static_cast<double>(plot.series.size());
    for(std::size_t i = 0; i < plot.categories.size(); ++i) {
      const double value = plot.series[k].y[i];
      if(!y.shows(value))
        continue;
      const double at = y.pixel(value);
      const double from = left + slot * (static_cast<double>(i) + 0.5 * (1 - filled));
      drawing.rectangle(from + width * static_cast<double>(k), std::min(at, base),
                        std::max(width - 1, 0.5), std::abs(at - base), color);
    }
  }
  for(std::size_t i = 0; i < plot.categories.size(); ++i) {
    const double middle = left + slot * (static_cast<double>(i) + 0.5);
    if(turned)
      drawing.text(middle + 4, bottom + font_size, plot.categories[i], "end", -45);
    else
      drawing.text(middle, bottom + 1.3 * font_size, plot.categories[i], "middle");
  }

  drawing.line(left, bottom, right, bottom, ink, 1);
  drawing.line(left, top, left, bottom, ink, 1);
  if(bars && base < bottom - 1)
    drawing.line(left, base, right, base, ink, 1);
  if(!plot.x_label.empty())
    drawing.text(0.5 * (left + right), plot.height - 10, plot.x_label, "middle");
  if(!plot.y_label.empty())
    drawing.text(1.1 * font_size, 0.5 * (top + bottom), plot.y_label, "middle", -90);
  double legend_y = top + font_size;
  for(std::size_t k = 0; has_legend && k < names.size(); ++k, legend_y += line_height) {
    const std::string color = palette[k % palette.size()];
    const double middle = legend_y - 0.35 * font_size;
    if(bars)
      drawing.rectangle(right + 12, middle - 5, 14, 10, color);
    else if(plot.series[k].shape != Series::Shape::marks)
      drawing.line(right + 10, middle, right + 28, middle, color, 2);
    if(!bars && plot.series[k].shape != Series::Shape::line)
      drawing.mark(right + 19, middle, color);
    drawing.text(right + 34, legend_y, names[k], "start");
  }
  return drawing.finish();
}

void write_plot(const std::string& svg_file, const Plot& plot)
{
  write_file(svg_file, svg_of_plot(plot));
}

}  // namespace support
