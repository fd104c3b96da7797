#!/usr/bin/env bash
# Makes the figures of the manual from CGAL's data: make_figures.sh DATA [BIN] [NAME...]
# DATA holds CGAL's meshes/, BIN the programs (build/bin otherwise); NAMEs are those of single figures. What is
# computed is kept in build/figures and made again only if it is missing. Pictures get smaller by pngquant
# if it is installed.
set -euo pipefail

if [ $# -lt 1 ] || [ ! -d "$1/meshes" ]; then
  echo "usage: make_figures.sh DATA [BIN] [NAME...]; DATA holds meshes/" >&2
  exit 1
fi
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
meshes=$1/meshes
bin=${2:-$root/build/bin}
shift
[ $# -gt 0 ] && shift
wanted=("$@")
fig=$root/doc/Point_set_consolidation_3/fig
work=$root/build/figures
mkdir -p "$work" "$fig"

# scan NAME MESH VIEWS POINTS [OPTION...]
scan() {
  local out=$work/$1.ply mesh=$2 views=$3 points=$4
  shift 4
  [ -s "$out" ] || "$bin/virtual_scan" "$meshes/$mesh" -o "$out" --views "$views" --points "$points" --seed 1 "$@"
}
# run OUTPUT PROGRAM ARGUMENT...: unless the output is there already
run() {
  local output=$work/$1 program=$2
  shift 2
  [ -s "$output" ] || "$bin/$program" --quiet "$@"
}
is_wanted() {
  [ ${#wanted[@]} -eq 0 ] && return
  local name
  for name in "${wanted[@]}"; do [ "$name" = "$1" ] && return; done
  return 1
}
# draw NAME ARGUMENT...: the picture, with few colours
draw() {
  local png=$fig/$1.png
  shift
  "$bin/make_picture" "$png" --quiet "$@"
  if command -v pngquant >/dev/null; then
    pngquant --force --skip-if-larger --strip --output "$png" 64 "$png" || true
  fi
}
side=(--view 0.9 -0.35 -0.6)   # where the first view of a scan did not look
small=(--height 300)
dots=(--point-radius 0.006)  # inner points of the knot: all alike

deep() { # NAME SCAN OPTION...: deep points, inner points and result
  local name=$1 input=$work/$2.ply
  shift 2
  run "$name.ply" consolidate_point_set "$input" -o "$work/$name.ply" --inner "$work/$name.inner.ply" \
    --deep-points "$work/$name.deep.ply" "$@"
}
complete() { # NAME SCAN OPTION...
  local name=$1 input=$work/$2.ply
  shift 2
  run "$name.ply" consolidate_point_set "$input" -o "$work/$name.points.ply" --completed "$work/$name.ply" \
    --mesh "$work/$name.mesh.ply" "$@"
}
skeleton() { # NAME SCAN OPTION...
  local name=$1 input=$work/$2.ply
  shift 2
  run "$name.ply" extract_skeleton "$input" -o "$work/$name.ply" "$@"
}
surface() { # NAME SCAN SKELETON OPTION...
  local name=$1 input=$work/$2.ply skeleton=$work/$3.ply
  shift 3
  run "$name.ply" reconstruct_surface "$input" -o "$work/$name.ply" --method skeleton-driven \
    --skeleton "$skeleton" "$@"
}

figure_one_view_completion() {
  scan armadillo armadillo.off 1 20000 --noise 0.2
  complete armadillo_completed armadillo
  draw one_view_completion --height 420 --panel "input=$work/armadillo.ply" \
    --panel "consolidated=$work/armadillo_completed.points.ply" \
    --panel "completed=$work/armadillo_completed.ply" --panel "mesh=$work/armadillo_completed.mesh.ply"
}
figure_method_completion() {
  scan elephant refined_elephant.off 1 20000 --noise 0.2
  complete elephant_completed elephant
  draw method_completion "${small[@]}" --panel "scan=$work/elephant.ply" \
    --panel "completed=$work/elephant_completed.ply" --panel "mesh=$work/elephant_completed.mesh.ply"
}
figure_parameter_particles() {
  scan armadillo armadillo.off 1 20000 --noise 0.2
  local n panels=()
  for n in 1000 4000 12000; do
    run "particles_$n.ply" consolidate_point_set "$work/armadillo.ply" --completed "$work/particles_$n.ply" \
      --particles "$n"
    panels+=(--panel "$n=$work/particles_$n.ply")
  done
  draw parameter_particles "${small[@]}" "${panels[@]}"
}
figure_parameter_denoising() {
  scan noisy bull.off 3 40000 --noise 2
  complete noisy_raw noisy --no-denoising
  complete noisy_denoised noisy
  draw parameter_denoising "${small[@]}" --panel "scan=$work/noisy.ply" --panel "without=$work/noisy_raw.mesh.ply" \
    --panel "denoised along the rays=$work/noisy_denoised.mesh.ply"
}
figure_parameter_outliers() {
  scan outliers cow.off 2 30000 --outliers 2
  complete outliers_kept outliers --keep-outliers
  complete outliers_out outliers
  draw parameter_outliers "${small[@]}" --panel "scan=$work/outliers.ply" \
    --panel "with outliers=$work/outliers_kept.mesh.ply" --panel "without=$work/outliers_out.mesh.ply"
}
figure_method_deep_points() {
  knot
  deep knot_deep knot --particles 3000 --data-term normal
  draw method_deep_points "${small[@]}" --panel "scan=$work/knot.ply" \
    --panel "meso-skeleton=$work/knot_deep.inner.ply" --panel "deep points=$work/knot_deep.deep.ply"
}
# parameter NAME SCAN OPTION KIND VALUE...: a panel for each value; KIND is inner, deep or empty (outer points)
parameter() {
  local name=$1 input=$2 option=$3 kind=$4 value panels=()
  shift 4
  for value in "$@"; do
    deep "${name}_$value" "$input" --particles 3000 "$option" "$value"
    panels+=(--panel "$value=$work/${name}_$value${kind:+.$kind}.ply")
  done
  local radius=()
  [ "$kind" = inner ] && radius=("${dots[@]}")
  draw "parameter_$name" "${small[@]}" "${radius[@]}" "${panels[@]}"
}
knot() { scan knot knot1.off 2 15000 --noise 0.2; }
hand() { scan hand hand.off 1 15000 --noise 0.2; }
figure_parameter_omega() { knot; parameter omega knot --omega inner 25 45 90; }
figure_parameter_sigma_p() { hand; parameter sigma_p hand --sigma-p "" 3 5 8; }
figure_parameter_sigma_q() { knot; parameter sigma_q knot --sigma-q inner 1 2 4; }
figure_parameter_mu() { knot; parameter mu knot --mu inner 0 0.4 1; }
figure_parameter_mu_hat() { hand; parameter mu_hat hand --mu-hat "" 0 0.4 0.8; }
figure_parameter_epsilon() { knot; parameter epsilon knot --epsilon inner 0.02 0.1 0.5; }
figure_parameter_prior() { hand; parameter prior hand --prior "" volume-preserving minimal-volume; }
figure_parameter_data_term() {
  scan knot_1 knot1.off 1 15000 --noise 0.2
  parameter data_term knot_1 --data-term "" full normal
}
figure_parameter_closing() {
  knot
  deep closing_without knot --particles 3000 --no-closing
  deep closing_with knot --particles 3000
  draw parameter_closing "${small[@]}" "${dots[@]}" --panel "without=$work/closing_without.inner.ply" \
    --panel "with=$work/closing_with.inner.ply"
}
figure_method_iterative() {
  scan iterative_input armadillo.off 3 20000 --outliers 1
  run iterative.ply consolidate_point_set "$work/iterative_input.ply" --method iterative -o "$work/iterative.ply"
  draw method_iterative "${small[@]}" --panel "input=$work/iterative_input.ply" --panel "result=$work/iterative.ply"
}
figure_parameter_hole_fairing() {  # an ellipsoid without a cap at the end of its long axis, z
  scan ellipsoid ellipsoid.off 6 8000 --truth "$work/ellipsoid.xyz"
  local input=$work/open_ellipsoid.xyz
  awk '$3 < 0.25' "$work/ellipsoid.xyz" >"$input"
  run grown.ply consolidate_point_set "$input" --method iterative -o "$work/grown.ply" --no-hole-fairing
  run faired.ply consolidate_point_set "$input" --method iterative -o "$work/faired.ply"
  draw parameter_hole_fairing "${small[@]}" --view 1 0 0 --point-radius 0.025 --panel "input=$input" \
    --panel "as grown=$work/grown.ply" --panel "faired=$work/faired.ply"
}
figure_method_anisotropic() {
  scan fandisk fandisk.off 4 20000 --noise 0.3
  local input=$work/fandisk.ply n=4000
  run fandisk_wlop.ply consolidate_point_set "$input" --method wlop --particles $n -o "$work/fandisk_wlop.ply"
  run fandisk_a.ply consolidate_point_set "$input" --method anisotropic-wlop --particles $n -o "$work/fandisk_a.ply"
  run fandisk_u.ply consolidate_point_set "$input" --method anisotropic-wlop --particles $n --upsample 16000 \
    -o "$work/fandisk_u.ply"
  draw method_anisotropic --height 210 --columns 2 --point-radius 0.012 --panel "input=$input" \
    --panel "WLOP=$work/fandisk_wlop.ply" --panel "anisotropic=$work/fandisk_a.ply" --panel "up-sampled=$work/fandisk_u.ply"
}
whole() { scan whole armadillo.off 6 12000; }
figure_method_segments() {
  whole
  local method panels=()
  for method in density-peaks persistence skeleton; do
    run "segments_$method.ply" segment_point_set "$work/whole.ply" -o "$work/segments_$method.ply" --method $method
    panels+=(--panel "$method=$work/segments_$method.ply")
  done
  draw method_segments "${small[@]}" "${panels[@]}"
}
figure_parameter_penalty() {
  whole
  local value panels=()
  for value in 0.05 0.4 3; do
    run "penalty_$value.ply" segment_point_set "$work/whole.ply" -o "$work/penalty_$value.ply" --penalty $value
    panels+=(--panel "$value=$work/penalty_$value.ply")
  done
  draw parameter_penalty "${small[@]}" "${panels[@]}"
}
figure_method_laplacian() {
  whole
  skeleton whole_skeleton whole
  draw method_laplacian "${small[@]}" --panel "points=$work/whole.ply" \
    --panel "skeleton=$work/whole.ply,$work/whole_skeleton.ply"
}
# skeletons NAME OPTION VALUE...
skeletons() {
  local name=$1 option=$2 value panels=()
  shift 2
  whole
  for value in "$@"; do
    skeleton "${name}_$value" whole --samples 3000 "$option" "$value"
    panels+=(--panel "$value=$work/${name}_$value.ply")
  done
  draw "parameter_$name" "${small[@]}" "${panels[@]}"
}
figure_parameter_contraction_factor() { skeletons contraction_factor --contraction-factor 1.5 3 10; }
figure_parameter_contraction_weight() { skeletons contraction_weight --contraction-weight 0.1 1 10; }
figure_parameter_laplacian_weights() { skeletons laplacian_weights --weights cotangent mean-value combinatorial; }
figure_parameter_sampling_radius() { skeletons sampling_radius --sampling-radius 0.01 0.02 0.05; }
figure_method_l1_medial() {
  scan knot_1 knot1.off 1 15000 --noise 0.2
  skeleton knot_l1 knot_1 --method l1-medial
  skeleton knot_laplacian knot_1 --samples 3000
  draw method_l1_medial "${small[@]}" --panel "scan=$work/knot_1.ply" --panel "L1-medial=$work/knot_l1.ply" \
    --panel "Laplacian=$work/knot_laplacian.ply"
}
partial() { # a scan, and a skeleton of all of the shape
  whole
  scan partial armadillo.off 2 8000
  skeleton whole_skeleton whole
}
figure_method_skeleton_driven() {
  partial
  surface driven partial whole_skeleton --resolution 96
  draw method_skeleton_driven "${small[@]}" "${side[@]}" --panel "scan=$work/partial.ply,$work/whole_skeleton.ply" \
    --panel "surface=$work/driven.ply"
}
# surfaces NAME OPTION VALUE...
surfaces() {
  local name=$1 option=$2 value panels=()
  shift 2
  partial
  for value in "$@"; do
    surface "${name}_$value" partial whole_skeleton "$option" "$value"
    panels+=(--panel "$value=$work/${name}_$value.ply")
  done
  draw "parameter_$name" "${small[@]}" "${side[@]}" "${panels[@]}"
}
figure_parameter_surface_weight() { surfaces surface_weight --surface-weight 0.5 50 5000; }
figure_parameter_skeleton_weight() { surfaces skeleton_weight --skeleton-weight 0 0.5 50; }
figure_parameter_resolution() { surfaces resolution --resolution 32 64 128; }
figure_parameter_outside() {
  partial
  local panels=() weight factor
  for pair in "0.0005 4" "0.005 4" "0.05 2"; do
    read -r weight factor <<<"$pair"
    surface "outside_${weight}_$factor" partial whole_skeleton --outside-weight "$weight" --outside-factor "$factor"
    panels+=(--panel "$weight, K $factor=$work/outside_${weight}_$factor.ply")
  done
  draw parameter_outside "${small[@]}" "${side[@]}" "${panels[@]}"
}

failed=()
for function in $(declare -F | sed -n 's/^declare -f figure_//p'); do
  is_wanted "$function" || continue
  echo "$function"
  ("figure_$function") || failed+=("$function")
done
if [ ${#failed[@]} -gt 0 ]; then
  echo "make_figures.sh: not made: ${failed[*]}" >&2
  exit 1
fi
