#include "space/left_out_points.h"

#include <utility>

#include "io/values_at.h"

namespace rbpa::app {

LeftOutPoints::LeftOutPoints(SpacePoints& cloud, std::span<const std::uint32_t> left_out) : whole_(std::move(cloud)) {
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < whole_.points.size(); ++i)
    if (next < left_out.size() && left_out[next] == i)
      ++next;
    else
      number_.push_back(i);
  cloud.points = values_at(whole_.points, number_);
  cloud.normals = values_at(whole_.normals, number_);
  cloud.colors = values_at(whole_.colors, number_);
  cloud.fields.clear();
  for (const std::vector<double>& field : whole_.fields) cloud.fields.push_back(values_at(field, number_));
}

void LeftOutPoints::add_last(const SpacePoints& cloud, std::size_t count) {
  if (!is_any()) return;
  for (std::size_t i = cloud.points.size() - count; i < cloud.points.size(); ++i) {
    number_.push_back(static_cast<std::uint32_t>(whole_.points.size()));
    whole_.points.push_back(cloud.points[i]);
    if (!whole_.normals.empty()) whole_.normals.push_back(cloud.normals[i]);
    if (!whole_.colors.empty()) whole_.colors.push_back(cloud.colors[i]);
  }
}

void LeftOutPoints::renumber(Surface& surface) const {
  if (!is_any()) return;
  for (auto& triangle : surface.triangles)
    for (std::uint32_t& corner : triangle) corner = number_[corner];
  for (Duplicate& duplicate : surface.duplicates) duplicate = {number_[duplicate.index], number_[duplicate.stands_for]};
}

void LeftOutPoints::renumber(SplitFans& fans) const {
  if (!is_any()) return;
  for (std::uint32_t& point : fans.point) point = number_[point];
}

void LeftOutPoints::renumber(SurfaceFacts& facts) const {
  if (is_any()) app::renumber(facts, number_);
}

void renumber(SurfaceFacts& facts, std::span<const std::uint32_t> number) {
  for (UnusedPoint& point : facts.unused) point.index = number[point.index];
  for (auto& repair : facts.repairs)
    for (std::size_t i = 0; repair && i < repair->points.size(); ++i) repair->points[i] = number[repair->points[i]];
  for (Hole& hole : facts.holes)
    for (RimEdge& edge : hole.edges) {
      edge.from = number[edge.from];
      edge.to = number[edge.to];
      if (edge.next == decltype(edge.next){}) continue;  // there is none
      for (std::uint32_t& corner : edge.next) corner = number[corner];
    }
}

template <typename Value>
std::vector<Value> LeftOutPoints::all(std::span<const Value> of_others, std::vector<Value> values) const {
  for (std::size_t i = 0; i < of_others.size(); ++i) values[number_[i]] = of_others[i];
  return values;
}

std::vector<Point3> LeftOutPoints::all_points(std::span<const Point3> of_others) const {
  return all(of_others, whole_.points);
}

std::vector<Point3> LeftOutPoints::all_normals(std::span<const Point3> of_others) const {
  if (of_others.empty()) return whole_.normals;
  return all(of_others, whole_.normals.empty() ? std::vector<Point3>(whole_.points.size()) : whole_.normals);
}

std::vector<double> LeftOutPoints::all_confidence(std::span<const double> of_others) const {
  if (of_others.empty()) return {};
  return all(of_others, std::vector<double>(whole_.points.size()));
}

std::vector<Point3> LeftOutPoints::seen_points(std::span<const Point3> of_others) const {
  if (of_others.empty()) return whole_.points;
  return all(of_others, std::vector<Point3>(whole_.points.size(), of_others.front()));
}

}  // namespace rbpa::app
