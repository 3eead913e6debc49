// budget: every option is a line or two here
#include "option_table.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>

#include "hgp/api/option_table.h"
#include "hgp/api/option_words.h"
#include "hgp/base/check.h"
#include "hgp/features/creases.h"

namespace hgp::cli {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// "" where a word is a number within the bounds, else why not. CLI11's own range checks print the largest double and
/// accept NaN.
std::string whyNoNumber(const std::string& word, double low, double high, bool isOpen) {
  double value = 0;
  const bool isNumber = CLI::detail::lexical_cast(word, value) && std::isfinite(value);
  if (isNumber && (isOpen ? value > low : value >= low) && value <= high) return "";
  const std::string bounds = high < kNoEnd ? formatText("from %g to %g", low, high)
                                           : (isOpen ? "> " : "≥ ") + formatText("%g", low);
  return "must be a number " + bounds + ", not '" + word + "'";
}

CLI::Validator atLeast(double low, bool isOpen = false) {
  return CLI::Validator(
      [low, isOpen](const std::string& word) { return whyNoNumber(word, low, kNoEnd, isOpen); },
      "");
}

CLI::Validator oneOf(const std::vector<std::string>& choices) { return CLI::IsMember(choices); }

/// An option that takes one of these words; the placeholder lists them. By default those of the core's table.
CLI::Option* choice(CLI::Option* option, std::vector<std::string> choices = {}) {
  if (choices.empty()) choices = api::wordsOfFlag("--" + option->get_lnames().front());
  return option->option_text(CLI::detail::join(choices, "|"))->check(oneOf(choices));
}

/// The marks of a list with commas; all for an empty one, none where a word is unknown.
std::optional<std::vector<prescription::FeatureMark>> marksOfList(const std::string& list) {
  return prescription::featureMarksNamed(list.empty() ? std::vector<std::string>()
                                                      : CLI::detail::split(list, ','));
}

class Table {
 public:
  Table(CLI::App& app, Arguments& out, TypedWords& words) : app_(app), out_(out), words_(words) {}

  CommandTable add() {
    addInspect();
    addCheck();
    addCones();
    addFeatureLists();
    addParam();
    addQuads();
    addVerify();
    addHelp();
    return std::move(table_);
  }

 private:
  CLI::App* add(const char* name, const char* description, Command command) {
    CLI::App* sub = app_.add_subcommand(name, description);
    sub->set_help_flag("-h,--help", "Print this help");
    table_.commands.push_back({sub, command});
    sub->add_option("MESH", out_.input,
                    "OBJ, OFF, PLY, STL, glTF or GLB, also gzipped; - for standard input")
        ->option_text(" ")
        ->required();
    return sub;
  }

  /// Adds the common options after a command's own ones.
  void addCommon(CLI::App* sub, const char* examples) {
    sub->option_defaults()->group("Input");
    choice(sub->add_option("--format", out_.format,
                           "Format of standard input (default: recognised from its bytes)"),
           {"obj", "off", "ply", "stl", "gltf", "glb"});
    sub->add_option("--mesh", words_.mesh,
                    "Which mesh of the file, from 0 (default: all for param and verify, the "
                    "largest where an option is of one mesh, as cones are)")
        ->option_text("all|largest|N");
    sub->add_option("--weld", words_.weld,
                    "Join vertices at equal positions, or closer than this length (default: exact "
                    "where every face is a component of its own)")
        ->option_text("exact|none|LENGTH");
    sub->add_option("--fix", words_.fix,
                    "Repairs to make: orient,split,degenerate or none (default: what is needed)")
        ->option_text("LIST");
    sub->add_flag("--strict", out_.load.isStrict,
                  "Repair and join nothing; refuse meshes that need it");
    sub->add_option("--root", out_.root,
                    "Read side files only below this folder (default: the input's)")
        ->option_text("DIR");
    sub->add_option("--max-bytes", out_.load.limits.maxBytes, "Refuse larger input (default 2 GiB)")
        ->option_text("N")
        ->check(atLeast(1));
    sub->add_option("--max-triangles", out_.load.limits.maxTriangles,
                    "Refuse more triangles (default 16 million)")
        ->option_text("N")
        ->check(atLeast(1));
    sub->add_option("--threads", out_.threads,
                    "Compute with this many threads, 1 to 16 (default: one per processor, at most "
                    "16); results do not depend on it")
        ->option_text("N")
        ->check(CLI::Range(1, kMaxThreads));
    sub->option_defaults()->group("Messages");
    sub->add_option("--json", out_.json,
                    "Write the machine-readable report to this file (- for standard output)")
        ->option_text("FILE");
    sub->add_flag("-q,--quiet", out_.isQuiet, "Print errors only");
    sub->add_flag("--no-progress", out_.hasNoProgress, "No progress on standard error");
    choice(sub->add_option("--color", out_.color,
                           "Colour the text (default: on a terminal, unless NO_COLOR is set)"),
           {"auto", "always", "never"});
    sub->footer(std::string("Examples:\n") + examples);
  }

  CLI::Option* repeatable(CLI::App* sub, const char* name, std::vector<std::string>& words,
                          const char* text, const char* description) {
    return sub->add_option(name, words, description)
        ->option_text(text)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
  }

  void addOrder(CLI::App* sub) {
    sub->add_option("--q", out_.q,
                    "Rotation order: cone angles are multiples of 360°/Q, 1 to 64 (default 4)")
        ->option_text("Q")
        ->check(CLI::Range(1, 64));
  }

  void addPrescription(CLI::App* sub) {
    sub->option_defaults()->group("Cones");
    addOrder(sub);
    sub->add_option("--cones", out_.cones,
                    "Cones: hgp-cones JSON, .cones, .sings, curvature list, _Th_hat, OBJ with c "
                    "lines")
        ->option_text("FILE");
    repeatable(sub, "--cone", words_.cone, "V:K",
               "A cone of angle K·360°/q at vertex V (from 0), or along features a corner of the "
               "boundary; "
               "repeatable");
    repeatable(sub, "--turning", words_.turning, "L:J",
               "Boundary loop L turns by J·360°/q; repeatable");
    repeatable(sub, "--handle", words_.handle, "G:R",
               "Rotation by R·360°/q along handle generator G; repeatable");
    sub->add_option(
           "--field", out_.field,
           "Direction field (.rawfield, .rosy, .ffield) whose cones and holonomy are prescribed")
        ->option_text("FILE");
    sub->add_flag("--ignore-embedded", out_.ignoresEmbedded,
                  "Do not use cones stored in the input");
    addFeatures(sub);
  }

  void addChoice(CLI::App* sub, const char* count) {
    sub->add_option(count, out_.solve.coneCount,
                    "Automatic cones: how many; 0, the default, is up to --cones-for")
        ->option_text("N")
        ->check(atLeast(0));
    choice(sub->add_option("--cones-for", words_.conesFor,
                           "Automatic cones: low distortion with boundaries followed (default); as "
                           "few as possible; as many as lower distortion; or a number halfway "
                           "between two of these"));
    sub->add_flag("--align", out_.solve.alignToCurvature,
                  "Automatic cones: follow the principal curvatures");
  }

  void addOutput(CLI::App* sub, const char* description, bool isRequired) {
    sub->option_defaults()->group("Output");
    sub->add_option("-o,--output", out_.output, description)
        ->option_text("FILE")
        ->required(isRequired);
  }

  void addGrid(CLI::App* sub) {
    sub->option_defaults()->group("Grid");
    sub->add_option(
           "--cells", words_.cells,
           "Align to a grid of about N cells: lines meet at every seam (q = 2, 4). auto, the "
           "default of quads: 14 along the diagonal, at least 800")
        ->option_text("N|auto")
        ->check(CLI::Validator(
            [](const std::string& word) {
              const api::OptionRow& row = *api::rowOfFlag<api::SolveOptions>("--cells");
              return word == "auto" ? std::string() : whyNoNumber(word, row.low, row.high, false);
            },
            ""));
    sub->add_option("--grid", out_.solve.grid.spacing,
                    "The same, given the edge length of a cell in units of the mesh")
        ->option_text("LENGTH")
        ->check(atLeast(0, true));
  }

  void addInspect() {
    CLI::App* sub = add("inspect", "Topology, defects, uv sets", Command::kInspect);
    sub->option_defaults()->group("Output");
    sub->add_option("--loops", out_.loops,
                    "Write the vertices of each boundary loop (L of --turning) and the edges that "
                    "each handle generator crosses (G of --handle), as JSON")
        ->option_text("FILE");
    addCommon(sub,
              "  hgp inspect mesh.obj\n"
              "  hgp inspect mesh.obj --json - | head -20");
  }

  void addCheck() {
    CLI::App* sub =
        add("check",
            "Whether any map can have a prescription (Gauss–Bonnet in integers); solves nothing",
            Command::kCheck);
    addPrescription(sub);
    addCommon(sub,
              "  hgp check mesh.obj --cones cones.json\n"
              "  hgp check mesh.obj --q 4 --cone 0:3 --cone 5:3");
  }

  void addCones() {
    CLI::App* sub =
        add("cones", "Choose cones, or convert them to hgp-cones JSON", Command::kCones);
    addOutput(sub, "Where to write (default: standard output)", false);
    sub->option_defaults()->group("Cones");
    addOrder(sub);
    addChoice(sub, "--count,--suggest");
    sub->add_option("--convert", out_.convert,
                    "Instead of choosing cones, convert this file of cones or of a field")
        ->option_text("FILE");
    CLI::Option* balance =
        sub->add_option("--balance", out_.balance,
                        "Keep the cones of this file and add those that Gauss–Bonnet misses, where "
                        "they cause the least distortion")
            ->option_text("FILE")
            ->excludes("--convert");
    CLI::Option* from = sub->add_option("--from", out_.from,
                                        "With --transfer: the mesh for which the cones were made")
                            ->option_text("MESH");
    CLI::Option* transfer =
        sub->add_option("--transfer", out_.transfer,
                        "Move the cones of this file from another version of the mesh, by the "
                        "positions of their vertices")
            ->option_text("FILE")
            ->needs(from)
            ->excludes("--convert")
            ->excludes(balance);
    from->needs(transfer);
    addCommon(sub,
              "  hgp cones mesh.obj -o cones.json\n"
              "  hgp cones mesh.obj --cones-for few\n"
              "  hgp cones mesh.obj --convert mesh.cones -o cones.json\n"
              "  hgp cones mesh.obj --balance mine.json -o cones.json\n"
              "  hgp cones new.obj --transfer cones.json --from old.obj -o cones-of-new.json");
  }

  void addFeatures(CLI::App* sub) {
    sub->option_defaults()->group("Features");
    sub->add_flag(
        "--rims", out_.everyMesh.hasRims,
        "Boundary edges become straight lines along the axes of the map, exactly (q = 4)");
    // This function is called after the table has been destroyed.
    const auto take = [&out = out_](const std::string& word) {
      double degrees = kCreaseDegrees;
      if (!word.empty()) CLI::detail::lexical_cast(word, degrees);
      out.everyMesh.creaseDegrees = degrees;
    };
    sub->add_option_function<std::string>("--creases", take,
                                          "So do edges with a dihedral angle above DEGREES "
                                          "(default 30), and the boundary edges of "
                                          "components that have any")
        ->option_text("[DEGREES]")
        ->expected(0, 1)
        ->check(CLI::Validator(
            [](const std::string& word) {
              double degrees = 0;
              const bool isGood = word.empty() || (CLI::detail::lexical_cast(word, degrees) &&
                                                   degrees > 0 && degrees < 180);
              return isGood ? std::string()
                            : "must be an angle between 0 and 180 degrees, not '" + word + "'";
            },
            ""));
    const auto takeMarks = [&out = out_](const std::string& list) {
      out.everyMesh.marks = marksOfList(list).value_or(std::vector<prescription::FeatureMark>());
    };
    sub->add_option_function<std::string>(
           "--marked", takeMarks,
           "So do edges that the file itself marks: lines,smoothing,materials,normals (default: "
           "all of these)")
        ->option_text("[LIST]")
        ->expected(0, 1)
        ->check(CLI::Validator(
            [](const std::string& word) {
              return marksOfList(word) ? std::string()
                                       : "must be of lines, smoothing, materials and normals, with "
                                         "commas between, not '" +
                                             word + "'";
            },
            ""));
    sub->add_option(
           "--features", out_.features,
           "So do these edges and all boundary edges: .sharp, OBJ with l lines, or rows of "
           "two vertices from 0")
        ->option_text("FILE");
  }

  void addFeatureLists() {
    CLI::App* sub = add("features",
                        "List creases, rims and marked edges, or convert such a list (default: "
                        "--creases)",
                        Command::kFeatures);
    addOutput(sub, "A .json, a .sharp, an .obj of l lines, or rows of two vertices (default: JSON)",
              false);
    addFeatures(sub);
    addCommon(sub,
              "  hgp features part.obj -o part.sharp\n"
              "  hgp features part.obj --creases 40 --rims -o features.json\n"
              "  hgp features part.obj --features part.sharp -o features.json");
  }

  void addSolve(CLI::App* sub) {
    sub->option_defaults()->group("Solve");
    choice(sub->add_option(
        "--boundary", words_.boundary,
        "convex: a disk onto a convex polygon (Tutte); rectangle: onto a rectangle, "
        "exactly, with four corners given by --cone V:1 or chosen (default free)"));
    choice(
        sub->add_option("--frames", words_.frames,
                        "auto: a smooth field that hgp computes; file: the directions of --field"));
    choice(sub->add_option(
        "--method", words_.method,
        "How to solve (default auto); printed: the paper's program, with a tie-break of 1e-5"));
    sub->add_option("--rounds", out_.solve.maxRounds,
                    "Rounds of solve, verify, repair (default 24)")
        ->option_text("N")
        ->check(CLI::Range(1, 1000));
    // These functions are called after the table has been destroyed.
    const auto improve = [&out = out_](const std::string& word) {
      const std::optional<double> balance = api::improveBalance(word);
      if (!balance)
        throw CLI::ValidationError("--improve",
                                   "must be isometric, conformal, area or a number from -1 "
                                   "(angles) through 0 (isometric) to 1 (areas), not '" +
                                       word + "'");
      out.solve.improve.emplace().balance = *balance;
    };
    sub->add_option_function<std::string>(
           "--improve", improve,
           "Lower the distortion: of both, of angles, of areas, or X from -1 (angles) to 1 (areas)")
        ->option_text("isometric|conformal|area|X");
    sub->add_flag_callback(
           "--quality", [&out = out_] { out.solve.improve.emplace(); },
           "The same as --improve isometric")
        ->excludes("--improve")
        ->option_text(" ");
    choice(sub->add_option("--symmetric", words_.symmetric,
                           "Solve one side of a plane that mirrors the mesh, and mirror the map: "
                           "across X, Y or Z through the centre, or whichever fits (q = 4)"));
    choice(sub->add_option("--scale", words_.scale,
                           "Scale of the map: as solved (default), mean edge length 1, or fitted "
                           "into the unit square"));
    sub->add_flag("--convex-polygons", out_.solve.convexPolygons,
                  "Certify only maps in which every polygon is convex, for readers that cut "
                  "polygons along other diagonals");
    sub->add_flag("--reproducible", out_.isReproducible,
                  "The same bytes on every processor and in WebAssembly, somewhat slower");
    sub->add_option("--time-limit", out_.timeLimit,
                    "Stop after this many seconds (exit code 6, nothing is written)")
        ->option_text("SECONDS")
        ->check(atLeast(0, true));
  }

  /// Adds a flag with an optional number.
  void addGridMaterial(CLI::App* sub) {
    const auto take = [&out = out_](const std::string& word) {
      double tiles = 0;
      if (!word.empty()) CLI::detail::lexical_cast(word, tiles);
      out.write.gridTiles = tiles;
    };
    sub->add_option_function<std::string>(
           "--grid-material", take,
           "glTF, OBJ: a grid as the material, TILES per unit of uv (default: large enough to see)")
        ->option_text("[TILES]")
        ->expected(0, 1)
        ->check(CLI::Validator(
            [](const std::string& word) {
              double tiles = 0;
              const bool isGood = word.empty() || (CLI::detail::lexical_cast(word, tiles) &&
                                                   std::isfinite(tiles) && tiles > 0);
              return isGood ? std::string() : "must be a number > 0, not '" + word + "'";
            },
            ""));
  }

  void addForce(CLI::App* sub) {
    sub->add_flag("-f,--force", out_.mayOverwrite, "Allow the output to replace the input");
  }

  void addRefine(CLI::App* sub) {
    sub->add_flag("--refine", out_.solve.refines,
                  "If there is no map, split edges, solve again, and write the refined mesh with "
                  "its map, or its quads");
  }

  void addParam() {
    CLI::App* sub = add("param", "Compute and write a certified map", Command::kParam);
    addOutput(sub, "Where to write (- for standard output)", true);
    addForce(sub);
    sub->add_option("--uv-set", words_.uvSet, "glTF: the set to write (default next)")
        ->option_text("next|N");
    repeatable(sub, "--also", out_.also, "FILE",
               "Write the mapped mesh also as x.obj, x.glb or x.gltf, the map as a flat mesh "
               "(x.flat.obj) or its edges (x.svg); repeatable");
    addGridMaterial(sub);
    sub->add_option("--faces", out_.faces,
                    "Write a table of all triangles: angle and area distortion, overlaps (CSV)")
        ->option_text("FILE");
    sub->add_flag_function(
        "--use", [&write = out_.write](std::int64_t n) { write.pointsMaterials = n > 0; },
        "glTF: make the materials' textures use the new set, or keep theirs (--use=false); "
        "default: move those whose set is missing or has no area");
    sub->add_flag("--embed", out_.isEmbedded,
                  ".gltf: embed buffers and images (default: copy them beside it)");
    sub->add_flag("--write-repairs", out_.load.writesRepairs,
                  "Write repairs into the output: flipped faces and split vertices");
    sub->add_flag("--compress", out_.isCompressed,
                  "glTF: compress it with meshopt, losing nothing (EXT_meshopt_compression)");
    sub->add_flag("--embed-cones", out_.write.embedCones, "Store the cones in the output");
    sub->add_flag("--allow-uncertified", out_.write.allowUncertified,
                  "Write the map even if it is not certified (the exit code is still 6)");
    sub->add_flag("--keep-going", out_.solve.keepsGoing,
                  "Write what is certified; other components keep their uv or are cut open to "
                  "disks (exit code 6)");
    addRefine(sub);
    sub->add_option("--xref", out_.xref, "Write the input vertex of every output texture vertex")
        ->option_text("FILE");
    addPrescription(sub);
    addChoice(sub, "--count");
    addSolve(sub);
    addGrid(sub);
    choice(sub->add_option("--grid-mode", words_.gridMode,
                           "quad: cones on grid points as well (default tile)"));
    addCommon(sub,
              "  hgp param mesh.obj -o mapped.obj\n"
              "  hgp param mesh.obj --cones cones.json -o mapped.obj --improve isometric\n"
              "  hgp param model.glb -o mapped.glb --json report.json\n"
              "  hgp param - -o - < mesh.obj > mapped.obj");
  }

  void addQuads() {
    CLI::App* sub =
        add("quads", "Align a map to a grid and write its cells as quads", Command::kQuads);
    addOutput(sub, "An .obj or .ply, or a .glb of triangles with an .obj beside it", true);
    addForce(sub);
    addPrescription(sub);
    addChoice(sub, "--count");
    addSolve(sub);
    addRefine(sub);
    addGrid(sub);
    addCommon(sub,
              "  hgp quads mesh.obj -o quads.obj\n"
              "  hgp quads mesh.obj --cells 400 --improve isometric -o quads.obj\n"
              "  hgp quads mesh.obj --grid 0.2 -o quads.obj");
  }

  void addVerify() {
    CLI::App* sub =
        add("verify", "Verify the texture coordinates that a file has", Command::kVerify);
    addPrescription(sub);
    sub->option_defaults()->group("Verdict");
    sub->add_option("--uv-set", words_.uvSet,
                    "Which uv set to verify (default: the last, where param writes)")
        ->option_text("N");
    sub->add_option("--tol", out_.verify.tolerance,
                    "Accept seam errors up to T of each edge's length and angle errors up to T rad "
                    "(default 1e-6), for files printed with few digits")
        ->option_text("T")
        ->check(atLeast(0));
    addCommon(sub,
              "  hgp verify mapped.obj\n"
              "  hgp verify mapped.obj --cones cones.json --json -\n"
              "  hgp verify mapped.obj --tol 1e-4");
  }

  void addHelp() {
    table_.help =
        app_.add_subcommand("help", "The same as --help, of a command where one is named");
    table_.help->add_option("COMMAND", words_.topic, "Which command")->option_text(" ");
    table_.help->footer("Examples:\n  hgp help\n  hgp help param");
    table_.completion = app_.add_subcommand("completion", "Print the completion script of a shell");
    table_.completion->add_option("SHELL", words_.shell, "bash, zsh or fish")
        ->option_text(" ")
        ->required()
        ->check(oneOf({"bash", "zsh", "fish"}));
    table_.completion->footer("Examples:\n  hgp completion bash > hgp.bash");
    table_.manual = app_.add_subcommand("manual", "Print the manual page (man -l reads it)");
    table_.manual->footer("Examples:\n  hgp manual > hgp.1");
    for (CLI::App* sub : {table_.help, table_.completion, table_.manual})
      sub->set_help_flag("-h,--help", "Print this help");
  }

  CLI::App& app_;
  Arguments& out_;
  TypedWords& words_;
  CommandTable table_;
};

}  // namespace

const char* exitCodeText() {
  return "  0  success: the map is certified, the mesh usable, the cones valid\n"
         "  2  wrong usage\n"
         "  3  the input cannot be read\n"
         "  4  the mesh cannot be parametrized as it is\n"
         "  5  no map can have these cones, turnings or rotations along handles\n"
         "  6  no certified map, or none within --time-limit\n"
         "  7  the output cannot be written\n"
         "  8  a limit was reached, or memory ran out\n"
         " 70  an internal error: a bug in hgp\n"
         "130  interrupted\n"
         "141  the reader of standard output closed it: ended by SIGPIPE, without a message";
}

CommandTable addCommands(CLI::App& app, Arguments& out, TypedWords& words) {
  return Table(app, out, words).add();
}

}  // namespace hgp::cli
