#include "cli/impact/impact_report.h"

#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "cli/command_line.h"
#include "cli/impact/html_text.h"
#include "cli/impact/report_sections.h"
#include "cli/impact/report_style.h"

namespace terrview {
namespace {

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

// Today, or the day of SOURCE_DATE_EPOCH.
std::string date_text() {
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t time = epoch == nullptr ? std::time(nullptr) : std::strtoll(epoch, nullptr, 10);
  std::tm utc{};
  gmtime_r(&time, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d", &utc);
  return text;
}

std::string title_of(const ImpactOptions& options) {
  return options.title.empty()
             ? std::filesystem::path(options.view.objects.buildings.front()).stem().string()
             : options.title;
}

std::string head(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src "
         "data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n<title>" +
         html_text(title) + "</title>\n<style>" + std::string(kReportStyle) + "</style>\n</head>\n";
}

std::string cover(const ReportParts& parts, const std::string& title) {
  std::string files;
  for (const std::string& path : parts.options.view.objects.buildings)
    files += (files.empty() ? "" : ", ") + file_name(path);
  return "<header>\n<p class=\"kind\">Visual impact study</p>\n<h1>" + html_text(title) +
         "</h1>\n<p class=\"meta\">" + html_text(files) + " · " + date_text() + " · terrview " +
         html_text(kVersion) + "</p>\n</header>\n";
}

}  // namespace

std::string report_html(const ReportParts& parts) {
  const std::string title = title_of(parts.options);
  std::string body = cover(parts, title) + "<main>\n" + summary_section(parts);
  for (const ViewpointStudy& viewpoint : parts.study.viewpoints)
    body += viewpoint_section(parts, viewpoint);
  body += method_section(parts) + "</main>\n";
  return head(title) + "<body>\n" + body + "<script>" + std::string(kReportScript) +
         "</script>\n</body>\n</html>\n";
}

}  // namespace terrview
