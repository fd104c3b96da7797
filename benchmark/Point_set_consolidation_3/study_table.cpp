// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "study_table.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace benchmark {

namespace {

/// A method without a result counts as so many times as bad as the reference: leaving it out would reward it.
constexpr double ratio_of_failure = 10.0;

std::vector<std::string> make_columns()
{
  std::vector<std::string> columns = {
      "points",      "seconds_method", "seconds_mesh", "forward_mean", "forward_rms",  "forward_95",
      "forward_max", "reverse_mean",   "reverse_rms",  "reverse_95",   "reverse_max",  "fscore_0.5",
      "fscore_1",    "seen_mean",      "unseen_mean",  "seen_share",   "normal_error", "flipped",
      "closed",      "components",     "genus",        "true_genus",   "volume_ratio"};
  for(const char* side : {"forward", "reverse"}) {
    for(double limit : distribution_limits) {
      std::ostringstream name;
      name << side << "_within_" << limit;
      columns.push_back(name.str());
    }
  }
  for(std::size_t i = 1; i <= Distance_statistics().quantiles.size(); ++i) {
    columns.push_back("forward_q"
                      + std::to_string(100 * i / Distance_statistics().quantiles.size()));
  }
  return columns;
}

const Study_row* find(const std::vector<Study_row>& rows, const std::string& model,
                      const std::string& spec, const std::string& method)
{
  for(const Study_row& row : rows) {
    if(row.model == model && row.spec == spec && row.method == method)
      return &row;
  }
  return nullptr;
}

/// A case of a method beside the same case of the reference.
struct Comparison {
  const Study_row* row;
  const Study_row* reference;

  double ratio(const std::string& column) const
  {
    if(row->failed())
      return ratio_of_failure;
    return row->value(column) / reference->value(column);
  }
};

std::vector<Comparison> compare(const std::vector<Study_row>& means, const std::string& reference)
{
  std::vector<Comparison> comparisons;
  for(const Study_row& row : means) {
    const Study_row* other = find(means, row.model, row.spec, reference);
    if(row.method != reference && other != nullptr && !other->failed())
      comparisons.push_back({&row, other});
  }
  return comparisons;
}

/// The words that occur, in order of their first occurrence.
template <typename Word>
std::vector<std::string> distinct(const std::vector<Study_row>& rows, Word word)
{
  std::vector<std::string> words;
  for(const Study_row& row : rows) {
    if(std::find(words.begin(), words.end(), word(row)) == words.end())
      words.push_back(word(row));
  }
  return words;
}

class Mean {
public:
  void add(double value)
  {
    m_sum += value;
    ++m_count;
  }
  double value() const { return m_count > 0 ? m_sum / static_cast<double>(m_count) : std::nan(""); }

private:
  double m_sum = 0.0;
  std::size_t m_count = 0;
};

std::string fixed(double value, int digits = 3)
{
  if(!std::isfinite(value))
    return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

void write_summary_row(std::ostream& out, const std::vector<Study_row>& means,
                       const std::vector<Comparison>& comparisons, const std::string& spec,
                       const std::string& method)
{
  std::size_t cases = 0;
  std::size_t failures = 0;
  const std::vector<std::string> columns
      = {"forward_mean", "reverse_mean", "seen_mean", "unseen_mean", "fscore_1", "normal_error"};
  std::vector<Mean> mean(columns.size());
  for(const Study_row& row : means) {
    if(row.spec != spec || row.method != method)
      continue;
    ++cases;
    failures += row.failed();
    for(std::size_t i = 0; i < columns.size() && !row.failed(); ++i)
      mean[i].add(row.value(columns[i]));
  }
  if(cases == 0)
    return;
  Mean log_forward, log_reverse, log_seen;
  std::size_t compared = 0;
  std::size_t better_forward = 0;
  std::size_t better_reverse = 0;
  double worst = 0.0;
  std::string worst_model = "-";
  for(const Comparison& comparison : comparisons) {
    if(comparison.row->spec != spec || comparison.row->method != method)
      continue;
    const double forward = comparison.ratio("forward_mean");
    const double reverse = comparison.ratio("reverse_mean");
    ++compared;
    log_forward.add(std::log(forward));
    log_reverse.add(std::log(reverse));
    log_seen.add(std::log(comparison.ratio("seen_mean")));
    better_forward += forward < 1.0;
    better_reverse += reverse < 1.0;
    if(forward > worst) {
      worst = forward;
      worst_model = comparison.row->model + " " + fixed(forward, 2);
    }
  }
  out << "| " << spec << " | " << method << " | ";
  for(const Mean& value : mean)
    out << fixed(value.value()) << " | ";
  if(compared > 0) {
    out << fixed(std::exp(log_forward.value()), 2) << " | "
        << fixed(std::exp(log_reverse.value()), 2) << " | " << fixed(std::exp(log_seen.value()), 2)
        << " | " << better_forward << "/" << compared << " | " << better_reverse << "/" << compared
        << " | " << worst_model << " | ";
  } else {
    out << " | | | | | | ";
  }
  out << failures << "/" << cases << " |\n";
}

}  // namespace

double Study_row::value(const std::string& column) const
{
  const std::vector<std::string>& columns = study_columns();
  const auto found = std::find(columns.begin(), columns.end(), column);
  if(found == columns.end())
    throw std::logic_error("no column " + column);
  return failed() ? std::nan("") : values[static_cast<std::size_t>(found - columns.begin())];
}

const std::vector<std::string>& study_columns()
{
  static const std::vector<std::string> columns = make_columns();
  return columns;
}

std::vector<double> study_values(const Mesh_verdict& verdict, std::size_t points,
                                 double seconds_method, double seconds_mesh)
{
  const Distance_statistics& forward = verdict.forward;
  const Distance_statistics& reverse = verdict.reverse;
  std::vector<double> values = {static_cast<double>(points),
                                seconds_method,
                                seconds_mesh,
                                forward.mean,
                                forward.rms,
                                forward.percentile_95,
                                forward.max,
                                reverse.mean,
                                reverse.rms,
                                reverse.percentile_95,
                                reverse.max,
                                verdict.fscore_half,
                                verdict.fscore_one,
                                verdict.seen.mean,
                                verdict.unseen.mean,
                                verdict.seen_share,
                                verdict.normals.mean_error,
                                verdict.normals.flipped,
                                verdict.topology.closed ? 1.0 : 0.0,
                                static_cast<double>(verdict.topology.components),
                                verdict.topology.genus,
                                verdict.true_topology.genus,
                                verdict.volume_ratio};
  values.insert(values.end(), forward.share_within.begin(), forward.share_within.end());
  values.insert(values.end(), reverse.share_within.begin(), reverse.share_within.end());
  values.insert(values.end(), forward.quantiles.begin(), forward.quantiles.end());
  return values;
}

std::string csv_header()
{
  std::string line = "model,spec,seed,method,error";
  for(const std::string& column : study_columns())
    line += "," + column;
  return line;
}

std::string to_csv(const Study_row& row)
{
  std::ostringstream line;
  line.precision(6);
  line << row.model << "," << row.spec << "," << row.seed << "," << row.method << "," << row.error;
  for(double value : row.values)
    line << "," << value;
  return line.str();
}

Study_row from_csv(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for(std::string cell; std::getline(stream, cell, ',');)
    cells.push_back(cell);
  // a row without a result ends with its error, which `getline` leaves out if it is empty
  if(cells.size() < 4)
    throw std::runtime_error("not a row of a study");
  Study_row row;
  row.model = cells[0];
  row.spec = cells[1];
  row.seed = std::stoull(cells[2]);
  row.method = cells[3];
  if(cells.size() > 4)
    row.error = cells[4];
  for(std::size_t i = 5; i < cells.size(); ++i)
    row.values.push_back(std::stod(cells[i]));
  if(!row.failed() && row.values.size() != study_columns().size()) {
    throw std::runtime_error("row of a study with other columns");
  }
  return row;
}

std::vector<Study_row> mean_over_seeds(const std::vector<Study_row>& rows)
{
  std::vector<Study_row> means;
  std::vector<std::size_t> counts;
  for(const Study_row& row : rows) {
    const auto same = std::find_if(means.begin(), means.end(), [&](const Study_row& mean) {
      return mean.model == row.model && mean.spec == row.spec && mean.method == row.method;
    });
    if(same == means.end()) {
      means.push_back(row);
      counts.push_back(1);
      continue;
    }
    ++counts[static_cast<std::size_t>(same - means.begin())];
    if(row.failed() || same->failed()) {
      if(same->error.empty())
        same->error = row.error;
      same->values.clear();
      continue;
    }
    for(std::size_t i = 0; i < row.values.size(); ++i)
      same->values[i] += row.values[i];
  }
  for(std::size_t i = 0; i < means.size(); ++i) {
    for(double& value : means[i].values)
      value /= static_cast<double>(counts[i]);
  }
  return means;
}

double mean_ratio(const std::vector<Study_row>& means, const std::string& spec,
                  const std::string& method, const std::string& reference,
                  const std::string& column)
{
  Mean log_ratio;
  for(const Comparison& comparison : compare(means, reference)) {
    if(comparison.row->spec == spec && comparison.row->method == method) {
      log_ratio.add(std::log(comparison.ratio(column)));
    }
  }
  return std::exp(log_ratio.value());
}

std::string markdown_report(const std::vector<Study_row>& means, const std::string& reference)
{
  std::vector<Comparison> comparisons = compare(means, reference);
  std::ostringstream out;
  out << "Distances in percent of the truth's bounding box diagonal, means over the models. Ratios "
         "to `"
      << reference
      << "` are geometric means over the models;\n\"better\" counts the cases below 1; a case "
         "without a result counts "
      << fixed(ratio_of_failure, 0) << ".\n\n"
      << "| spec | method | truth->mesh | mesh->truth | seen | unseen | F 1 % | normals | ratio "
         "truth->mesh | "
         "ratio mesh->truth | ratio seen | better | better rev. | worst | no result |\n"
      << "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  const auto specs = distinct(means, [](const Study_row& row) { return row.spec; });
  const auto methods = distinct(means, [](const Study_row& row) { return row.method; });
  for(const std::string& spec : specs) {
    for(const std::string& method : methods)
      write_summary_row(out, means, comparisons, spec, method);
  }

  std::stable_sort(comparisons.begin(), comparisons.end(),
                   [](const Comparison& a, const Comparison& b) {
                     return a.ratio("forward_mean") > b.ratio("forward_mean");
                   });
  out << "\n## Cases, losses first\n\n"
      << "| model | spec | method | ratio fwd | ratio rev | " << reference
      << ": fwd / rev / seen / unseen / F1 | fwd / rev / seen / unseen / F1 | volume | components "
         "| genus (truth) |\n"
      << "|---|---|---|---|---|---|---|---|---|---|\n";
  const auto numbers = [](const Study_row& row) {
    return fixed(row.value("forward_mean")) + " / " + fixed(row.value("reverse_mean")) + " / "
           + fixed(row.value("seen_mean")) + " / " + fixed(row.value("unseen_mean")) + " / "
           + fixed(row.value("fscore_1"));
  };
  for(const Comparison& comparison : comparisons) {
    const Study_row& row = *comparison.row;
    out << "| " << row.model << " | " << row.spec << " | " << row.method << " | "
        << fixed(comparison.ratio("forward_mean"), 2) << " | "
        << fixed(comparison.ratio("reverse_mean"), 2) << " | " << numbers(*comparison.reference)
        << " | ";
    if(row.failed()) {
      out << row.error << " | | | |\n";
    } else {
      out << numbers(row) << " | " << fixed(row.value("volume_ratio"), 2) << " | "
          << fixed(row.value("components"), 1) << " | " << fixed(row.value("genus"), 1) << " ("
          << fixed(row.value("true_genus"), 0) << ") |\n";
    }
  }
  for(const Study_row& row : means) {
    if(row.method == reference && row.failed()) {
      out << "| " << row.model << " | " << row.spec << " | " << row.method << " | | | " << row.error
          << " | | | | |\n";
    }
  }
  return out.str();
}

}  // namespace benchmark
