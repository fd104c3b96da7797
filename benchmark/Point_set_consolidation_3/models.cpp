// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "models.h"

#include "arguments.h"
#include "judge.h"
#include "point_file.h"
#include "virtual_scanner.h"

#include <algorithm>
#include <cstdlib>

namespace benchmark {

const std::vector<Model>& models()
{
  // Facets and Euler number were checked with CGAL's polygon mesh processing. A few self-intersections (man, bull,
  // camel, cow, diplodocus, elk) lie where fingers, ears or legs touch; they matter neither for rays from outside
  // nor for distances.
  static const std::vector<Model> list = {
      {"armadillo", "tuning", "free form with limbs and fine detail, the papers' standard model"},
      {"refined_elephant", "tuning",
       "free form, thick body with thin ears, genus 3 (legs and trunk touch)"},
      {"fandisk", "tuning", "CAD part: flat faces, sharp edges"},
      {"knot1", "tuning", "tube of constant radius, genus 1"},
      {"man", "check", "standing figure, limbs close to the body"},
      {"bear", "check", "one compact body"},
      {"bunny00", "check", "compact body with thin ears, real scan"},
      {"cactus", "check", "fat tubes with branches, few and large facets"},
      {"cow", "check", "four legs, horns"},
      {"bull", "check", "four thin legs, thin tail"},
      {"camel", "check", "long thin legs, occlusions between them"},
      {"homer", "check", "smooth body with large flat regions"},
      {"dino", "check", "long neck and tail, small volume"},
      {"hand", "check", "flat shape, fingers side by side"},
      {"triceratops", "extra", "plate-like crest"},
      {"diplodocus", "extra", "very long thin tail"},
      {"elk", "extra", "antlers, genus 1"},
      {"anchor_dense", "extra", "CAD part with holes, genus 4"},
      {"eight", "extra", "two fat loops, genus 2"},
  };
  return list;
}

std::vector<Model> select_models(const std::vector<std::string>& words)
{
  std::vector<Model> selected;
  for(const std::string& word : words) {
    bool known = false;
    for(const Model& model : models()) {
      if(word != "all" && word != model.group && word != model.name)
        continue;
      known = true;
      const bool already = std::any_of(selected.begin(), selected.end(), [&](const Model& other) {
        return other.name == model.name;
      });
      if(!already)
        selected.push_back(model);
    }
    if(!known)
      throw Usage_error("unknown model '" + word + "'");
  }
  return selected;
}

std::string data_folder(const std::string& given)
{
  if(!given.empty())
    return given;
  const char* environment = std::getenv("CGAL_DATA_DIR");
  if(environment == nullptr)
    throw Usage_error("where CGAL's data are: --data DIR or environment variable CGAL_DATA_DIR");
  return environment;
}

support::Triangle_mesh load_model(const Model& model, const std::string& data)
{
  const std::string file = data + "/meshes/" + model.name + ".off";
  support::Triangle_mesh mesh = normalized(support::read_mesh(file));
  const Topology topology = topology_of(mesh);
  if(!topology.closed || topology.components != 1 || topology.volume <= 0.0) {
    throw support::File_error(file
                              + ": not a closed mesh of one component that is oriented outwards");
  }
  return mesh;
}

}  // namespace benchmark
