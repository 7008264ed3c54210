#include "cli/run.h"

#include <cstdio>
#include <exception>
#include <map>
#include <new>

#include "cli/batch/batch_command.h"
#include "cli/command_line.h"
#include "cli/impact/impact_command.h"
#include "cli/info_command.h"
#include "cli/interrupt.h"
#include "cli/overview_command.h"
#include "cli/quantize_command.h"
#include "cli/say_error.h"
#include "cli/scene/scene_command.h"
#include "cli/sky_command.h"
#include "cli/synth_command.h"
#include "cli/view_command.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr const char* kUsage =
    "terrview: what can be seen of a landscape from a point on the Earth\n"
    "\n"
    "  terrview [view] DEM... --eye LAT,LON,ALT [options] [-o OUT]   one picture\n"
    "  terrview batch JOBS --dem DEM... -o '{name}.png'              many, from a table\n"
    "  terrview impact DEM... --buildings F --viewpoints F -o DIR    what a project changes\n"
    "  terrview overview DEM... [options] [-o OUT]                   a whole region\n"
    "  terrview SCENE.json|SCENE.xml [options] [-o OUT]              what a scene file describes\n"
    "  terrview info DEM... [--json]                                 what DEMs hold\n"
    "  terrview sky [--clouds 0..1] [--seed N] [-o OUT]              a sky, wood, marble\n"
    "  terrview synth [--relief plain|ridged|eroded] [-o OUT.tif]    a height grid\n"
    "  terrview quantize IN -o OUT --colors N [options]              a picture with a palette\n"
    "\n"
    "ALT is in metres; +2 is two metres above the ground. See terrview view --help.\n";

using Command = int (*)(const std::vector<std::string>& args);

int dispatch(std::vector<std::string> args) {
  static const std::map<std::string, Command> kCommands{
      {"batch", run_batch},       {"impact", run_impact},     {"info", run_info},
      {"overview", run_overview}, {"quantize", run_quantize}, {"sky", run_sky},
      {"synth", run_synth},       {"view", run_view}};
  if (args.empty()) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  if (args.front() == "-h" || args.front() == "--help") {
    std::fputs(kUsage, stdout);
    return 0;
  }
  const auto command = kCommands.find(args.front());
  if (command == kCommands.end())
    return is_scene_name(args.front()) ? run_scene(args) : run_view(args);
  args.erase(args.begin());
  return command->second(args);
}

}  // namespace

int run(const std::vector<std::string>& args) {
  catch_interrupts();
  try {
    return dispatch(args);
  } catch (const NothingToDo&) {
    return 0;
  } catch (const Interrupted& interrupted) {
    if (interrupted.left.empty())
      say_error("interrupted: nothing was written");
    else
      say_error("interrupted: '" + interrupted.left + "' is as far as it came");
    return 130;
  } catch (const InputError& error) {
    say_error(error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    say_error("out of memory: use a --window of the DEM or a smaller --size");
  } catch (const std::exception& error) {
    say_error(error.what());
  }
  return 1;
}

}  // namespace terrview
