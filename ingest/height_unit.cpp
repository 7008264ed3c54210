#include "ingest/height_unit.h"

#include <array>
#include <cctype>
#include <string>

namespace terrview {
namespace {

struct HeightUnit {
  std::string_view name;  // lower case, letters only
  double metres;
};

constexpr double kFoot_m = 0.3048;
constexpr double kSurveyFoot_m = 1200.0 / 3937.0;

constexpr std::array kUnits{
    HeightUnit{"m", 1},
    HeightUnit{"metre", 1},
    HeightUnit{"metres", 1},
    HeightUnit{"meter", 1},
    HeightUnit{"meters", 1},
    HeightUnit{"mm", 1e-3},
    HeightUnit{"millimetre", 1e-3},
    HeightUnit{"millimeter", 1e-3},
    HeightUnit{"cm", 1e-2},
    HeightUnit{"centimetre", 1e-2},
    HeightUnit{"centimetres", 1e-2},
    HeightUnit{"centimeter", 1e-2},
    HeightUnit{"centimeters", 1e-2},
    HeightUnit{"dm", 1e-1},
    HeightUnit{"decimetre", 1e-1},
    HeightUnit{"decimeter", 1e-1},
    HeightUnit{"km", 1e3},
    HeightUnit{"kilometre", 1e3},
    HeightUnit{"kilometer", 1e3},
    HeightUnit{"ft", kFoot_m},
    HeightUnit{"foot", kFoot_m},
    HeightUnit{"feet", kFoot_m},
    HeightUnit{"internationalfoot", kFoot_m},
    HeightUnit{"internationalfeet", kFoot_m},
    HeightUnit{"usft", kSurveyFoot_m},
    HeightUnit{"ftus", kSurveyFoot_m},
    HeightUnit{"footus", kSurveyFoot_m},
    HeightUnit{"sft", kSurveyFoot_m},
    HeightUnit{"surveyfoot", kSurveyFoot_m},
    HeightUnit{"surveyfeet", kSurveyFoot_m},
    HeightUnit{"ussurveyfoot", kSurveyFoot_m},
    HeightUnit{"ussurveyfeet", kSurveyFoot_m},
    HeightUnit{"yd", 0.9144},
    HeightUnit{"yard", 0.9144},
    HeightUnit{"fathom", 1.8288},
    HeightUnit{"fathoms", 1.8288},
};

}  // namespace

std::optional<double> metres_per_height_unit(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalpha(byte) != 0) letters.push_back(static_cast<char>(std::tolower(byte)));
  }
  for (const HeightUnit& unit : kUnits) {
    if (unit.name == letters) return unit.metres;
  }
  return std::nullopt;
}

}  // namespace terrview
