// Features of vector files, through GDAL's OGR: GeoJSON, GeoPackage, Shapefile and whatever else it
// opens.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

class OGRFeature;
class OGRGeometry;

namespace terrview {

class VectorFeature {
 public:
  VectorFeature(const std::string& file, int number, const OGRFeature& feature)
      : file_(file), number_(number), feature_(feature) {}

  // In file order, from 1.
  [[nodiscard]] int number() const { return number_; }

  // Null where the feature has none.
  [[nodiscard]] const OGRGeometry* geometry() const;

  // The first of the fields named that is set, not null and not empty. Names match whatever their
  // case, and ':' or '_'. Dates with a time are ISO 8601, with an offset only if the field has one.
  [[nodiscard]] std::optional<std::string> text(std::span<const std::string_view> names) const;

  // The same as one line without blanks at its ends; control characters become blanks. Empty where
  // there is none. Throws InputError for what is no UTF-8.
  [[nodiscard]] std::string line(std::span<const std::string_view> names) const;

  // The names of the fields that features of this file have, parted by commas; the first twenty.
  [[nodiscard]] std::string fields() const;

  // Throws InputError where features of this file have no such field.
  void require_field(std::string_view name) const;

  // Throws InputError: 'file', feature N: what is wrong.
  [[noreturn]] void refuse(const std::string& what) const;

 private:
  const std::string& file_;
  int number_;
  const OGRFeature& feature_;
};

struct VectorFile {
  std::string name;     // as given by the user
  std::string crs_wkt;  // empty = none
  bool geographic = false;
  int features = 0;
  std::vector<std::string> warnings;  // one line each, for the user
};

// Reads the first layer of a file and hands over its features in order. Throws InputError for a
// file that is broken anywhere, if need be after some features were handed over.
VectorFile read_vector_file(const std::string& path,
                            const std::function<void(const VectorFeature& feature)>& take);

}  // namespace terrview
