// What: GDAL as this program uses it: set up once, silent, its errors as texts.
#pragma once

#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <string>

namespace rbpa::app {

/// While it lives GDAL knows its drivers and says nothing by itself.
class Gdal {
 public:
  Gdal() {
    static_cast<void>(drivers_are_known());
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~Gdal() { CPLPopErrorHandler(); }
  Gdal(const Gdal&) = delete;
  Gdal& operator=(const Gdal&) = delete;

  /// Whether anything failed since it was made.
  bool has_failed() const { return CPLGetLastErrorType() >= CE_Failure; }
  /// What GDAL says about it.
  std::string reason() const {
    const std::string text = CPLGetLastErrorMsg();
    return text.empty() ? "nothing that GDAL knows" : text;
  }

 private:
  static bool drivers_are_known() {
    static const bool known = (GDALAllRegister(), true);
    return known;
  }
};

}  // namespace rbpa::app
