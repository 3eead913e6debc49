#include "arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "also.h"
#include "files.h"
#include "hgp/api/option_table.h"
#include "hgp/api/option_words.h"
#include "hgp/api/session.h"
#include "hgp/api/session/side_files.h"
#include "hgp/base/check.h"
#include "hgp/text/nearest.h"
#include "manual.h"
#include "option_table.h"

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
  throw CLI::ValidationError(option, "must be two integers like 12:3, not '" + text + "'");
}

/// "obj" for "x.OBJ"; empty for extensions to which files are not converted.
std::string formatOf(const std::string& name) {
  std::string extension = name.substr(std::min(name.rfind('.'), name.size() - 1) + 1);
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  return extension == "obj" || extension == "glb" || extension == "gltf" ? extension : "";
}

/// LoadOptions::target of an output file.
std::string targetOf(const std::string& name) {
  constexpr std::string_view kPly = ".ply";
  return name.size() > kPly.size() && name.substr(name.size() - kPly.size()) == kPly
             ? "ply"
             : formatOf(name);
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
      throw CLI::ValidationError(
          "--fix", "must be a list of orient, split, degenerate, or none; not '" + word + "'");
    }
    begin = comma + 1;
  }
}

class Parser {
 public:
  Parser()
      : app_("Seamless, provably fold-free texture coordinates with cones of your choice.", "hgp") {
    app_.require_subcommand(1);
    app_.allow_windows_style_options(false);  // "/tmp/part.obj" is a file there, too
    app_.set_version_flag("-V,--version", std::string("hgp ") + api::version());
    app_.set_help_flag("-h,--help", "Print this help");
    table_ = addCommands(app_, out_, words_);
    app_.footer(std::string("Examples:\n") +
                "  hgp inspect mesh.obj\n"
                "  hgp param mesh.obj -o mapped.obj\n"
                "  hgp verify mapped.obj\n"
                "\n'hgp help COMMAND' lists the options of a command.\n\nExit codes:\n" +
                exitCodeText());
  }

  Parsed parse(int count, char** words) {
    try {
      app_.parse(count, words);
      const CLI::App* used = app_.get_subcommands().front();
      refuseDuplicates(*used);
      refuseOptionsAsValues(*used);
      if (used == table_.help) return print(help());
      if (used == table_.completion) return print(completionScript(app_, words_.shell));
      if (used == table_.manual) return print(manualPage(app_, api::version()));
      for (const auto& [app, command] : table_.commands) {
        if (app == used) out_.command = command;
      }
      finish();
      return {out_, 0};
    } catch (const CLI::CallForHelp&) {
      return print(app_.help());
    } catch (const CLI::CallForVersion&) {
      return print(std::string("hgp ") + api::version() + "\n");
    } catch (const CLI::ParseError& error) {
      std::fprintf(stderr, "hgp: %s\n", message(error, count, words).c_str());
    }
    return {std::nullopt, kUsage};
  }

 private:
  static Parsed print(const std::string& text) {
    const Status written = writeText("-", text);
    if (!written) std::fprintf(stderr, "hgp: %s\n", written.error().message.c_str());
    return {std::nullopt, written ? 0 : exitCode(written.error().code)};
  }

  std::string help() const {
    if (words_.topic.empty()) return helpOf(app_, "");
    std::vector<std::string> names;
    for (const CLI::App* sub : app_.get_subcommands([](const CLI::App*) { return true; })) {
      if (sub->get_name() == words_.topic) return helpOf(*sub, "hgp");
      names.push_back(sub->get_name());
    }
    const std::string nearest = text::nearestOf(words_.topic, names);
    throw CLI::ValidationError("help",
                               "there is no command '" + words_.topic + "'" +
                                   (nearest.empty() ? "" : "; did you mean " + nearest + "?"));
  }
  /// CLI11's help text; CLI11 itself would print that of the command `help`.
  static std::string helpOf(const CLI::App& app, const std::string& before) {
    const std::string name = (before.empty() ? "" : before + " ") + app.get_name();
    return app.get_formatter()->make_help(&app, name, CLI::AppFormatMode::Normal);
  }

  void finish() {
    if (!words_.fix.empty()) takeFix(words_.fix, out_.load.fix);
    if (words_.fix == "none") out_.load.isStrict = true;
    takeMesh();
    if (const auto weld = api::weldNamed(words_.weld)) {
      out_.load.weld = *weld;
    } else if (!words_.weld.empty()) {
      if (!CLI::detail::lexical_cast(words_.weld, out_.load.weld) || !(out_.load.weld >= 0) ||
          !std::isfinite(out_.load.weld)) {
        throw CLI::ValidationError(
            "--weld", "must be 'exact', 'none' or a length, not '" + words_.weld + "'");
      }
    }
    if (!words_.uvSet.empty() && words_.uvSet != "next") {
      // More sets can be read than are written.
      const bool isRead = out_.command == Command::kVerify;
      const api::OptionRow* row = isRead ? api::rowOfFlag<api::VerifyOptions>("--uv-set")
                                         : api::rowOfFlag<api::WriteOptions>("--uv-set");
      int set = -1;
      if (!CLI::detail::lexical_cast(words_.uvSet, set) || set < 0 || set > row->high) {
        throw CLI::ValidationError(
            "--uv-set", formatText("must be 'next' or a number from 0 to %g, not '", row->high) +
                            words_.uvSet + "'");
      }
      out_.write.uvSet = out_.verify.uvSet = set;
    }
    for (const std::string& c : words_.cone) out_.cone.push_back(takePair(c, "--cone"));
    for (const std::string& t : words_.turning) out_.turning.push_back(takePair(t, "--turning"));
    for (const std::string& h : words_.handle) out_.handle.push_back(takePair(h, "--handle"));
    takeWords(out_.solve);
    if (out_.q) out_.solve.q = out_.verify.q = *out_.q;
    const bool isSaid = !words_.cells.empty() || out_.solve.grid.spacing > 0;
    out_.solve.choosesCells =
        words_.cells == "auto" || (out_.command == Command::kQuads && !isSaid);
    if (!words_.cells.empty() && words_.cells != "auto")
      CLI::detail::lexical_cast(words_.cells, out_.solve.grid.cells);
    if (out_.command == Command::kQuads) out_.solve.grid.mode = GridMode::kQuad;
    if (out_.command == Command::kParam) out_.load.target = targetOf(out_.output);
    refuseContradictions();
    refuseSharedInput();
  }

  void takeWords(api::SolveOptions& o) const {
    o.boundary = api::boundaryNamed(words_.boundary).value_or(o.boundary);
    o.method = methodNamed(words_.method).value_or(o.method);
    o.conesFor = conesForNamed(words_.conesFor).value_or(o.conesFor);
    o.frames = api::framesNamed(words_.frames).value_or(o.frames);
    o.scale = api::scaleNamed(words_.scale).value_or(o.scale);
    o.symmetry = api::symmetryNamed(words_.symmetric).value_or(o.symmetry);
    o.grid.mode = api::gridModeNamed(words_.gridMode).value_or(o.grid.mode);
  }

  void takeMesh() {
    const bool isAsked = !out_.cones.empty() || !words_.cone.empty() || !words_.turning.empty() ||
                         !words_.handle.empty() || !out_.field.empty() || !out_.features.empty() ||
                         !out_.xref.empty() || !out_.also.empty() || !out_.faces.empty();
    out_.isEveryMesh = words_.mesh == "all" || (words_.mesh.empty() && !isAsked);
    if (words_.mesh == "all" && isAsked) {
      throw CLI::ValidationError(
          "--mesh all",
          "cannot be combined with cones, --features, --field, --xref, --faces or "
          "--also: they apply to one mesh");
    }
    if (words_.mesh.empty() || words_.mesh == "all" || words_.mesh == "largest") return;
    if (!CLI::detail::lexical_cast(words_.mesh, out_.load.surface) || out_.load.surface < 0) {
      throw CLI::ValidationError("--mesh",
                                 "must be 'all', 'largest' or a number, not '" + words_.mesh + "'");
    }
  }

  void refuseContradictions() const {
    const auto refuse = [](const char* text) { throw CLI::ValidationError(text); };
    if (out_.load.isStrict &&
        (out_.load.fix.orient || out_.load.fix.split || out_.load.fix.degenerate))
      refuse("--strict and --fix exclude each other");
    if (!out_.cones.empty() && !out_.cone.empty()) refuse("--cones and --cone exclude each other");
    const bool isAsked = !out_.cones.empty() || !out_.cone.empty() || !out_.turning.empty() ||
                         !out_.handle.empty() || !out_.field.empty() || out_.hasFeatures();
    if (isAsked && out_.solve.boundary == api::BoundaryKind::kConvex) {
      refuse(
          "--boundary convex cannot be combined with cones, turning, handles, features or a field");
    }
    if (out_.solve.frames == api::FrameSource::kFile && out_.field.empty())
      refuse("--frames file needs --field");
    if (out_.solve.refines && !words_.symmetric.empty())
      refuse("--refine and --symmetric exclude each other: a refined mesh is not symmetric");
    const GridOptions& grid = out_.solve.grid;
    if (!words_.cells.empty() && grid.spacing > 0) refuse("--cells and --grid exclude each other");
    const bool isGrid = grid.isAsked() || out_.solve.choosesCells;
    if (!words_.gridMode.empty() && !isGrid) refuse("--grid-mode needs --cells or --grid");
    if (isGrid && !words_.scale.empty() && words_.scale != "solved") {
      refuse("--scale unit and fit would undo a grid: one cell is one unit of uv");
    }
    if (isGrid && out_.solve.boundary == api::BoundaryKind::kConvex)
      refuse("--boundary convex has no seams to align to a grid");
    const bool isGltf = out_.load.target == "glb" || out_.load.target == "gltf";
    if (out_.isCompressed && !isGltf && out_.output != "-")
      refuse("--compress is for glTF: name the result -o x.glb or -o x.gltf");
    const std::string format = targetOf(out_.output);
    const bool isOther = !format.empty() && format != "glb" && format != "gltf";
    if (isOther && out_.write.uvSet >= 0)
      refuse("--uv-set is for glTF; other formats have one set");
    if (isOther && out_.isEmbedded) refuse("--embed is for glTF: name the result -o x.gltf");
    if (out_.isCompressed && !api::canCompress())
      refuse("--compress: this program was built without an encoder (libmeshoptimizer)");
    for (const std::string& name : out_.also) {
      if (!alsoFormat(name))
        throw CLI::ValidationError(
            "--also", "must be x.obj, x.flat.obj, x.glb, x.gltf or x.svg, not '" + name + "'");
    }
    if (out_.write.gridTiles && formatOf(out_.output).empty())
      refuse("--grid-material is for glTF and OBJ: name the result -o x.glb or -o x.obj");
    if (out_.json == "-" && out_.output == "-")
      refuse("--json - and -o - cannot share standard output");
  }

  void refuseSharedInput() const {
    int count = 0;
    for (const std::string* file : {&out_.input, &out_.cones, &out_.field, &out_.features,
                                    &out_.balance, &out_.transfer, &out_.from})
      count += *file == "-";
    if (count > 1)
      throw CLI::ValidationError("standard input can be read once: only one file is -");
  }

  static bool isRepeatable(const std::string& name) {
    return name == "--cone" || name == "--turning" || name == "--handle" || name == "--also";
  }
  static void refuseDuplicates(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
      if (option->count() > 1 && !isRepeatable(option->get_name())) {
        throw CLI::ValidationError(option->get_name(), "is given more than once");
      }
    }
  }

  /// `--json --creases` would write a file of that name, and no creases would be followed.
  static void refuseOptionsAsValues(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& value : option->results()) {
        if (value.compare(0, 2, "--") != 0 || app.get_option_no_throw(value) == nullptr) continue;
        throw CLI::ValidationError(
            option->get_name(),
            formatText("needs a value, and '%s' is an option; a file of that name is ./%s",
                       value.c_str(), value.c_str()));
      }
    }
  }

  const CLI::App& usedApp() const {
    const auto used = app_.get_subcommands();
    return used.empty() ? app_ : *used.front();
  }

  /// CLI11's message, with the nearest known word if one was not understood.
  std::string message(const CLI::ParseError& error, int count, char** words) const {
    const std::vector<std::string> extra = usedApp().remaining();
    const bool isExtra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
    if (isExtra && &usedApp() != &app_ && !extra.empty() && extra[0].compare(0, 1, "-") != 0)
      return "one mesh per call, and '" + extra[0] +
             "' is another one; for many files: xargs or parallel (docs/batch.md)";
    std::string text = error.what();
    while (!text.empty() && text.back() == '\n') text.pop_back();
    std::vector<std::string> names;
    const CLI::App& app = usedApp();
    if (&app == &app_) {
      for (const CLI::App* sub : app_.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(sub->get_name());
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
      if (!isOption) text = "there is no command '" + word + "'";
      const std::string nearest = text::nearestOf(word, names);
      if (!nearest.empty()) text += "; did you mean " + nearest + "?";
      break;
    }
    return text + "\n     'hgp " + (&app == &app_ ? "" : app.get_name() + " ") +
           "--help' lists what there is";
  }

  CLI::App app_;
  Arguments out_;
  TypedWords words_;
  CommandTable table_;
};

}  // namespace

Parsed parseArguments(int count, char** words) { return Parser().parse(count, words); }

}  // namespace hgp::cli
