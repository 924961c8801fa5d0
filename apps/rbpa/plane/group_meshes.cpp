#include <optional>
#include <string>
#include <vector>

#include "io/failure.h"
#include "io/mesh/write_triangles.h"
#include "io/number.h"
#include "picture/picture.h"
#include "plane/group_run.h"
#include "plane/triangle_outputs.h"
#include "shared/arguments.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

/// Throws WrongUsage for an option or a target that does not apply to groups.
void require_of_groups(const MeshArguments& arguments, const ComplexRequest& request,
                       const std::vector<Target>& targets) {
  refuse_given({{arguments.levels.has_value(), "--levels"},
                {arguments.segments.has_value(), "--segments"},
                {arguments.complex != "solid", "--complex full"},
                {request.method.leaf_capacity.has_value(), "--method hrbpa"},
                {request.method.by_paper, "--search paper"}},
               not_with_groups);
  for (const Target& target : targets)
    if (is_picture(target.format))
      bad_usage("--group-by", output_name(target.path),
                "a mesh or an array (rbpa shape --group-by draws its polygons)");
}

/// The group of each triangle, and the properties of each group: number of points, alpha, area, and the name if all
/// names are numbers.
struct GroupNumbers {
  explicit GroupNumbers(const GroupRun& run) {
    const GroupShapes& shapes = run.shapes;
    features.name = "group";
    features.names = run.named.names;
    features.names_are_numbers = run.named.are_numbers;
    for (std::size_t g = 0; g < run.sizes.size(); ++g) {
      features.of_triangle.insert(features.of_triangle.end(), shapes.triangle_begin[g + 1] - shapes.triangle_begin[g],
                                  static_cast<std::uint32_t>(g));
      points.push_back(static_cast<double>(run.sizes[g]));
      areas.push_back(shapes.totals[g].area);
      if (run.named.are_numbers) names.push_back(parse_whole_number(run.named.names[g]).value);
    }
    features.numbers = {{"points", points}, {"alpha", shapes.alphas}, {"area", areas}};
    if (run.named.are_numbers) features.numbers.insert(features.numbers.begin(), {"name", names});
  }
  GroupNumbers(const GroupNumbers&) = delete;
  GroupNumbers& operator=(const GroupNumbers&) = delete;

  TriangleFeatures features;
  std::vector<double> names, points, areas;
};

void write_targets(GroupRun& run, bool compacted) {
  const ProgressLine line = run.writing();
  const GroupNumbers numbers(run);
  const TriangleMesh whole{
      run.named.file.points, run.shapes.triangles,     {}, {}, &numbers.features, {}, run.named.file.z,
      run.named.file.index,  {run.named.file.kept, {}}};
  std::optional<CompactMesh> compact;
  if (compacted) compact.emplace(whole);
  for (const Target& target : run.request.targets) {
    const bool is_array = target.format == Format::npy;
    add_triangles(run, target, compact && !is_array ? compact->mesh() : whole, run.named.file);
  }
}

}  // namespace

void run_group_meshes(const MeshArguments& arguments) {
  const std::vector<Target> targets = parse_targets(Use::triangles, arguments, arguments.points, {arguments.levels});
  GroupRequest request = parse_group_request(arguments, targets);
  const std::optional<FieldChoice> keeps = parse_fields_of(arguments.fields, targets);
  for (PointSource& source : request.sources.files) {
    source.heights = any_has_vertices(targets);
    source.keeps = keeps;
  }
  require_of_groups(arguments, request.complex, targets);
  GroupShapesOptions options;
  options.triangles = true;
  GroupRun run(request, arguments, options);
  run.warning_on_fields(run.named.file.kept, targets, run.shapes.duplicates);
  write_targets(run, arguments.compact);
  run.finish();
  caution(targets, run.named.file.points, run.named.file);
  run.summarize(counted(run.triangles(), "triangle"));
}

}  // namespace rbpa::app
