// What: draws a figure of panels in rows, with arrows between them: before, operator, after.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drawings/drawn_mesh.h"
#include "meshops/topology/count.h"

namespace figures {

struct Panel {
  DrawnMesh drawn;
  Marks marks;
  std::vector<std::string> caption = {};  ///< lines under the panel
  std::string heading = {};
  /// Draws additional elements on top.
  std::function<void(Canvas&, const Frame&)> more = {};
  std::vector<Place> extent = {};  ///< places that the panel must show besides those of the mesh
};

/// Returns a panel with the counts of its mesh as caption.
Panel counted(const DrawnMesh& drawn, const Marks& marks = {});

/// Names of the operator from a panel to the next one, and of its inverse.
struct Arrow {
  std::string there, back;  ///< `back` may be empty
  std::string note = {};    ///< in small letters above the arrow
};

class Sheet {
 public:
  /// Starts a sheet. Panels are at least `least_width` pixels wide, so that their captions fit.
  explicit Sheet(std::string title, double pixels_per_unit = 50, double least_width = 220)
      : title_(std::move(title)), scale_(pixels_per_unit), least_width_(least_width) {}

  /// Adds a row of panels, with an arrow between them if there are two.
  Sheet& row(const std::vector<Panel>& panels, const std::optional<Arrow>& arrow = {}) {
    rows_.push_back({panels, arrow});
    return *this;
  }
  Sheet& row(const Panel& before, const Arrow& arrow, const Panel& after) { return row({before, after}, arrow); }

  std::string svg() const;

 private:
  struct Row {
    std::vector<Panel> panels;
    std::optional<Arrow> arrow;
  };
  std::string title_;
  double scale_;
  double least_width_;
  std::vector<Row> rows_;
};

/// Throws when the counts differ: the inverse of an operator did not restore them.
void require_same_counts(const DrawnMesh& before, const DrawnMesh& there_and_back);

}  // namespace figures
