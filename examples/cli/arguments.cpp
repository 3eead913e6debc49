// budget: every option is a line or two here
#include "arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>

#include "hgp/api/session.h"
#include "nearest.h"

namespace hgp::cli {
namespace {

constexpr int kUsage = 2;

/// "12:3"
std::pair<int, int> takePair(const std::string& text, const char* option) {
  const std::size_t colon = text.find(':');
  try {
    std::size_t used = 0, usedToo = 0;
    if (colon != std::string::npos) {
      const int a = std::stoi(text.substr(0, colon), &used);
      const int b = std::stoi(text.substr(colon + 1), &usedToo);
      if (used == colon && usedToo == text.size() - colon - 1) return {a, b};
    }
  } catch (const std::logic_error&) {
  }
  throw CLI::ValidationError(option, "wants two integers like 12:3, not '" + text + "'");
}

/// CLI11's own range checks print the largest double, and let NaN through.
CLI::Validator atLeast(double low, bool isOpen = false) {
  const auto check = [low, isOpen](const std::string& text) {
    double value = 0;
    const bool isNumber = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
    if (isNumber && (isOpen ? value > low : value >= low)) return std::string();
    return "wants a number " + std::string(isOpen ? "> " : "≥ ") + (low == 0 ? "0" : "1") +
           ", not '" + text + "'";
  };
  return CLI::Validator(check, "");
}

void takeFix(const std::string& text, FixOptions& fix) {
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, comma - begin);
    if (word == "orient")
      fix.orient = true;
    else if (word == "split")
      fix.split = true;
    else if (word == "degenerate")
      fix.degenerate = true;
    else if (word != "none") {
      throw CLI::ValidationError("--fix",
                                 "wants a list of orient, split, degenerate; not '" + word + "'");
    }
    begin = comma + 1;
  }
}

class Parser {
 public:
  Parser()
      : app_("Seamless, provably fold-free texture coordinates with cones of your choice.", "hgp") {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", std::string("hgp ") + api::version());
    app_.set_help_flag("-h,--help", "Print this help");
    addInspect();
    addCheck();
    addCones();
    addParam();
    addQuads();
    addVerify();
    app_.footer(
        "Exit codes: 0 done (and certified) · 2 usage · 3 unreadable input · 4 unsupported "
        "geometry ·\n5 cones no map can have · 6 no certified map · 7 write failed · 8 limit or "
        "memory ·\n70 internal error · 130 interrupted");
  }

  Parsed parse(int count, char** words) {
    try {
      app_.parse(count, words);
      const CLI::App* used = app_.get_subcommands().front();
      refuseDuplicates(*used);
      for (const auto& [app, command] : commands_) {
        if (app == used) out_.command = command;
      }
      finish();
      return {out_, 0};
    } catch (const CLI::CallForHelp&) {
      std::cout << usedApp().help();
    } catch (const CLI::CallForAllHelp&) {
      std::cout << usedApp().help();
    } catch (const CLI::CallForVersion&) {
      std::cout << "hgp " << api::version() << "\n";
    } catch (const CLI::ParseError& error) {
      std::cerr << "hgp: " << message(error, count, words) << "\n";
      return {std::nullopt, kUsage};
    }
    return {std::nullopt, 0};
  }

 private:
  CLI::App* add(const char* name, const char* description, Command command) {
    CLI::App* sub = app_.add_subcommand(name, description);
    sub->set_help_flag("-h,--help", "Print this help");
    commands_.push_back({sub, command});
    sub->add_option("input", out_.input,
                    "OBJ, OFF, PLY, STL, glTF or GLB, also gzipped; - for standard input")
        ->required();
    sub->add_option("--format", out_.format,
                    "Format of standard input: obj, off, ply, stl, gltf, glb");
    sub->add_option("--json", out_.json,
                    "Write the machine-readable report here (- for standard output)");
    sub->add_flag("--quiet", out_.isQuiet, "Print errors only");
    sub->add_flag("--no-progress", out_.hasNoProgress, "No progress on standard error");
    sub->add_option("--color", out_.color, "Colour the text: auto, always or never")
        ->check(CLI::IsMember({"auto", "always", "never"}));
    sub->add_option("--mesh", mesh_,
                    "all, largest, or which mesh of the file, from 0 (default: all for param and "
                    "verify without cones, the largest otherwise)");
    sub->add_option("--weld", weld_,
                    "exact, none, or join vertices closer than this length (default: exact where "
                    "every face is a component of its own)");
    sub->add_option("--fix", fix_,
                    "Repairs to make: orient,split,degenerate or none (default: what is needed)");
    sub->add_flag("--strict", out_.load.isStrict, "Repair and join nothing; refuse what needs it");
    sub->add_option("--root", out_.root,
                    "Read side files below this folder only (default: the input's)");
    sub->add_option("--max-bytes", out_.load.limits.maxBytes, "Refuse larger input")
        ->check(atLeast(1));
    sub->add_option("--max-triangles", out_.load.limits.maxTriangles, "Refuse more triangles")
        ->check(atLeast(1));
    return sub;
  }

  void addPrescription(CLI::App* sub) {
    sub->add_option("--q", out_.q,
                    "Rotation order: cone angles are multiples of 360°/q (default 4)")
        ->check(CLI::Range(1, 64));
    sub->add_option(
        "--cones", out_.cones,
        "Cones: hgp-cones JSON, .cones, .sings, curvature list, _Th_hat, OBJ with c lines");
    sub->add_option("--cone", cone_,
                    "A cone V:K at vertex V (from 0) of angle K·360°/q; repeatable")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
    sub->add_option("--turning", turning_, "Turning index L:J of boundary loop L; repeatable")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
    sub->add_option("--handle", handle_, "Rotation G:R along handle generator G; repeatable")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
    sub->add_option("--field", out_.field,
                    "Take cones and holonomy from a .rawfield, .rosy or .ffield");
    sub->add_flag("--ignore-embedded", out_.ignoresEmbedded,
                  "Do not use cones stored in the input");
  }

  void addInspect() { add("inspect", "Topology, defects, uv sets", Command::kInspect); }

  void addCheck() {
    addPrescription(
        add("check", "The exact angle budget of a prescription; solves nothing", Command::kCheck));
  }

  void addChoice(CLI::App* sub, const char* count) {
    sub->add_option(count, out_.solve.coneCount, "Automatic cones: how many")->check(atLeast(0));
    sub->add_option("--cones-for", conesFor_, "Automatic cones: balanced, few or low-distortion")
        ->check(CLI::IsMember({"balanced", "few", "low-distortion"}));
    sub->add_flag("--align", out_.solve.alignToCurvature, "Follow the principal curvatures");
  }

  void addCones() {
    CLI::App* sub =
        add("cones", "Choose cones, or convert them to hgp-cones JSON", Command::kCones);
    sub->add_option("-o,--output", out_.output, "Where to write (default: standard output)");
    sub->add_option("--q", out_.q, "Rotation order (default 4)")->check(CLI::Range(1, 64));
    addChoice(sub, "--count,--suggest");
    sub->add_option("--convert", out_.convert, "Convert this file of cones or of a field instead");
  }

  void addParam() {
    CLI::App* sub = add("param", "Compute and write a certified map", Command::kParam);
    addPrescription(sub);
    sub->add_option("-o,--output", out_.output, "Where to write (- for standard output)")
        ->required();
    sub->add_option("--boundary", boundary_,
                    "free, or convex: a disk onto a convex polygon (Tutte)")
        ->check(CLI::IsMember({"free", "convex"}));
    addChoice(sub, "--count");
    sub->add_option("--frames", frames_,
                    "auto: a smooth field of our own; file: the directions of --field")
        ->check(CLI::IsMember({"auto", "file"}));
    sub->add_option("--rounds", out_.solve.maxRounds, "Rounds of solve, judge, repair (default 24)")
        ->check(CLI::Range(1, 1000));
    sub->add_option("--method", method_, "auto, harmonic, soft, printed (the paper's), all-frames")
        ->check(CLI::IsMember({"auto", "harmonic", "soft", "printed", "all-frames"}));
    const auto improve = [this](const std::string& word) {
      out_.solve.improve.emplace().balance = api::improveBalance(word).value_or(std::nan(""));
    };
    sub->add_option_function<std::string>(
        "--improve", improve,
        "Less distortion: isometric, conformal, area or -1 (angles) … 1 (areas)");
    sub->add_flag_callback(
           "--quality", [this] { out_.solve.improve.emplace(); }, "The same as --improve isometric")
        ->excludes("--improve");
    sub->add_option("--scale", scale_, "solved, unit (mean edge 1) or fit (into the unit square)")
        ->check(CLI::IsMember({"solved", "unit", "fit"}));
    addGrid(sub);
    sub->add_option("--grid-mode", gridMode_, "tile, or quad: cones on grid points as well")
        ->check(CLI::IsMember({"tile", "quad"}));
    sub->add_option("--uv-set", uvSet_, "next, or the number of the set to write");
    sub->add_option("--time-limit", out_.timeLimit, "Give up after so many seconds")
        ->check(atLeast(0, true));
    sub->add_flag("--embed-cones", out_.write.embedCones, "Store the cones in the output");
    sub->add_flag("--allow-uncertified", out_.write.allowUncertified,
                  "Write the map even when it is not certified (exit code 6 all the same)");
    sub->add_flag("--keep-going", out_.solve.keepsGoing,
                  "Write what is certified; what is not keeps its uv or lies flat (exit code 6)");
    sub->add_option("--xref", out_.xref, "Write which input vertex every output vertex is");
    sub->add_flag("--force", out_.mayOverwrite, "Allow the output to replace the input");
  }

  void addGrid(CLI::App* sub) {
    sub->add_option("--cells", out_.solve.grid.cells,
                    "Align to a grid of about so many cells: lines meet at every seam (q = 2, 4)")
        ->check(atLeast(1));
    sub->add_option("--grid", out_.solve.grid.spacing, "The same by the edge length of a cell")
        ->check(atLeast(0, true));
  }

  void addQuads() {
    CLI::App* sub = add("quads", "Align to a grid and write its cells as quads", Command::kQuads);
    addPrescription(sub);
    sub->add_option("-o,--output", out_.output, "An .obj, or a .glb of triangles for a look")
        ->required();
    sub->add_option("--count", out_.solve.coneCount, "Automatic cones: roughly how many")
        ->check(atLeast(0));
    addGrid(sub);
  }

  void addVerify() {
    CLI::App* sub =
        add("verify", "Judge the texture coordinates that a file has", Command::kVerify);
    addPrescription(sub);
    sub->add_option("--uv-set", uvSet_, "Which set (default: the last, where param writes)");
    sub->add_option("--tol", out_.verify.tolerance,
                    "Accept seams within this part of each edge's length and angles within this "
                    "many radians "
                    "(default 1e-6), for files printed with few digits")
        ->check(atLeast(0));
  }

  void finish() {
    if (!fix_.empty()) takeFix(fix_, out_.load.fix);
    if (fix_ == "none") out_.load.isStrict = true;
    takeMesh();
    if (weld_ == "exact") {
      out_.load.weld = 0;
    } else if (weld_ == "none") {
      out_.load.weld = api::LoadOptions::kWeldNever;
    } else if (!weld_.empty()) {
      if (!CLI::detail::lexical_cast(weld_, out_.load.weld) || !(out_.load.weld >= 0) ||
          !std::isfinite(out_.load.weld)) {
        throw CLI::ValidationError("--weld",
                                   "wants 'exact', 'none' or a length, not '" + weld_ + "'");
      }
    }
    if (!uvSet_.empty() && uvSet_ != "next") {
      int set = -1;
      if (!CLI::detail::lexical_cast(uvSet_, set) || set < 0) {
        throw CLI::ValidationError("--uv-set", "wants 'next' or a number, not '" + uvSet_ + "'");
      }
      out_.write.uvSet = out_.verify.uvSet = set;
    }
    for (const std::string& c : cone_) out_.cone.push_back(takePair(c, "--cone"));
    for (const std::string& t : turning_) out_.turning.push_back(takePair(t, "--turning"));
    for (const std::string& h : handle_) out_.handle.push_back(takePair(h, "--handle"));
    if (boundary_ == "convex") out_.solve.boundary = api::BoundaryKind::kConvex;
    if (const auto method = methodNamed(method_)) out_.solve.method = *method;
    if (const auto choice = conesForNamed(conesFor_)) out_.solve.conesFor = *choice;
    if (frames_ == "file") out_.solve.frames = api::FrameSource::kFile;
    if (scale_ == "unit") out_.solve.scale = api::Scale::kUnit;
    if (scale_ == "fit") out_.solve.scale = api::Scale::kFit;
    if (gridMode_ == "quad") out_.solve.grid.mode = GridMode::kQuad;
    if (out_.q) out_.solve.q = out_.verify.q = *out_.q;
    if (out_.command == Command::kQuads) out_.solve.grid.mode = GridMode::kQuad;
    refuseContradictions();
  }

  void takeMesh() {
    const bool isAsked = !out_.cones.empty() || !cone_.empty() || !turning_.empty() ||
                         !handle_.empty() || !out_.field.empty() || !out_.xref.empty();
    out_.isEveryMesh = mesh_ == "all" || (mesh_.empty() && !isAsked);
    if (mesh_ == "all" && isAsked) {
      throw CLI::ValidationError("--mesh all",
                                 "takes no cones, field or xref: they are of one mesh");
    }
    if (mesh_.empty() || mesh_ == "all" || mesh_ == "largest") return;
    if (!CLI::detail::lexical_cast(mesh_, out_.load.surface) || out_.load.surface < 0) {
      throw CLI::ValidationError("--mesh",
                                 "wants 'all', 'largest' or a number, not '" + mesh_ + "'");
    }
  }

  void refuseContradictions() const {
    const auto refuse = [](const char* text) { throw CLI::ValidationError(text); };
    if (out_.load.isStrict &&
        (out_.load.fix.orient || out_.load.fix.split || out_.load.fix.degenerate))
      refuse("--strict and --fix contradict each other");
    if (!out_.cones.empty() && !out_.cone.empty())
      refuse("--cones and --cone contradict each other");
    const bool isAsked = !out_.cones.empty() || !out_.cone.empty() || !out_.turning.empty() ||
                         !out_.handle.empty() || !out_.field.empty();
    if (isAsked && out_.solve.boundary == api::BoundaryKind::kConvex) {
      refuse("--boundary convex takes no cones, turning, handles or field");
    }
    if (out_.solve.frames == api::FrameSource::kFile && out_.field.empty())
      refuse("--frames file needs --field");
    const GridOptions& grid = out_.solve.grid;
    if (grid.cells > 0 && grid.spacing > 0) refuse("--cells and --grid contradict each other");
    if (out_.command == Command::kQuads && !grid.isAsked())
      refuse("quads needs --cells, about how many, or --grid, how large");
    if (!gridMode_.empty() && !grid.isAsked()) refuse("--grid-mode needs --cells or --grid");
    if (grid.isAsked() && !scale_.empty() && scale_ != "solved") {
      refuse("--scale unit and fit would undo a grid: one cell is one unit of uv");
    }
    if (grid.isAsked() && out_.solve.boundary == api::BoundaryKind::kConvex)
      refuse("--boundary convex has no seams to align to a grid");
    if (out_.json == "-" && out_.output == "-")
      refuse("--json - and -o - cannot share standard output");
    if (out_.input == "-" && out_.format.empty()) refuse("standard input needs --format");
  }

  static bool isRepeatable(const std::string& name) {
    return name == "--cone" || name == "--turning" || name == "--handle";
  }
  static void refuseDuplicates(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
      if (option->count() > 1 && !isRepeatable(option->get_name())) {
        throw CLI::ValidationError(option->get_name(), "is given more than once");
      }
    }
  }

  const CLI::App& usedApp() const {
    const auto used = app_.get_subcommands();
    return used.empty() ? app_ : *used.front();
  }

  /// CLI11's text, and the nearest word where one was not understood.
  std::string message(const CLI::ParseError& error, int count, char** words) const {
    std::string text = error.what();
    while (!text.empty() && text.back() == '\n') text.pop_back();
    std::vector<std::string> names;
    const CLI::App& app = usedApp();
    if (&app == &app_) {
      for (const auto& entry : commands_) names.push_back(entry.first->get_name());
    } else {
      for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
      }
    }
    for (int i = 1; i < count; ++i) {
      const std::string word = std::string(words[i]).substr(0, std::string(words[i]).find('='));
      const bool isOption = word.compare(0, 2, "--") == 0;
      if (isOption != (&app != &app_)) continue;
      if (std::find(names.begin(), names.end(), word) != names.end()) continue;
      const std::string nearest = nearestOf(word, names);
      if (!nearest.empty()) text += "; did you mean " + nearest + "?";
      break;
    }
    return text + "\n     'hgp " + (&app == &app_ ? "" : app.get_name() + " ") +
           "--help' lists what there is";
  }

  CLI::App app_;
  Arguments out_;
  std::vector<std::pair<CLI::App*, Command>> commands_;
  std::string mesh_, weld_, fix_, boundary_, conesFor_, frames_, method_, scale_, uvSet_, gridMode_;
  std::vector<std::string> cone_, turning_, handle_;
};

}  // namespace

Parsed parseArguments(int count, char** words) { return Parser().parse(count, words); }

}  // namespace hgp::cli
