#include "manual.h"

#include <CLI/CLI.hpp>

namespace hgp::cli {
namespace {

std::vector<const CLI::App*> commandsOf(const CLI::App& app) {
  const auto all = app.get_subcommands([](const CLI::App*) { return true; });
  std::vector<const CLI::App*> shown;
  for (const CLI::App* one : all)
    if (!one->get_group().empty()) shown.push_back(one);
  return shown;
}

/// Options with names, hidden ones and --help's short form included.
std::vector<const CLI::Option*> optionsOf(const CLI::App& app) {
  std::vector<const CLI::Option*> options;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_lnames().empty() && !option->get_group().empty()) options.push_back(option);
  return options;
}

bool takesValue(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::string escapedFor(const std::string& text, const std::string& special,
                       const std::string& escape) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) out += escape;
    out += c;
  }
  return out;
}

/// Text of man(7): backslashes and hyphens as themselves, no line that looks like a request.
std::string roff(const std::string& text) {
  std::string out = escapedFor(text, "\\-", "\\");
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool isAtStart = i == 0 || out[i - 1] == '\n';
    if (isAtStart && (out[i] == '.' || out[i] == '\'')) out.insert(i, "\\&");
  }
  return out;
}

void describeOptions(const CLI::App& app, std::string& out) {
  for (const CLI::Option* option : optionsOf(app)) {
    out += ".TP\n\\fB";
    for (const std::string& name : option->get_snames()) out += "\\-" + roff(name) + "\\fR, \\fB";
    out += "\\-\\-" + roff(option->get_lnames().front()) + "\\fR";
    if (takesValue(*option)) out += " \\fI" + roff(option->get_type_name()) + "\\fR";
    out += "\n" + roff(option->get_description()) + "\n";
  }
}

std::string bashScript(const std::vector<const CLI::App*>& commands) {
  std::string names, cases;
  for (const CLI::App* command : commands) {
    names += command->get_name() + " ";
    std::string words;
    for (const CLI::Option* option : optionsOf(*command))
      words += " --" + option->get_lnames().front();
    cases += "    " + command->get_name() + ") words=\"" + words.substr(1) + "\" ;;\n";
  }
  return "# bash completion of hgp\n_hgp() {\n"
         "  local current=\"${COMP_WORDS[COMP_CWORD]}\" words=\"\"\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         names +
         "--help --version\" -- \"$current\"))\n    return\n  fi\n"
         "  case \"${COMP_WORDS[1]}\" in\n" +
         cases +
         "  esac\n  case \"$current\" in\n"
         "    -*) COMPREPLY=($(compgen -W \"$words\" -- \"$current\")) ;;\n"
         "    *) COMPREPLY=($(compgen -f -- \"$current\")) ;;\n  esac\n}\n"
         "complete -o filenames -F _hgp hgp\n";
}

std::string zshScript(const std::vector<const CLI::App*>& commands) {
  const auto quoted = [](const std::string& text) {
    std::string out;
    for (const char c : escapedFor(text, "[]:", "\\"))
      out += c == '\'' ? "'\\''" : std::string(1, c);
    return out;
  };
  std::string list, cases;
  for (const CLI::App* command : commands) {
    list += "    '" + command->get_name() + ":" + quoted(command->get_description()) + "'\n";
    cases += "    " + command->get_name() + ") _arguments";
    for (const CLI::Option* option : optionsOf(*command)) {
      cases += " \\\n      '--" + option->get_lnames().front() + "[" +
               quoted(option->get_description()) + "]";
      cases += takesValue(*option) ? ":" + quoted(option->get_type_name()) + ":_files'" : "'";
    }
    cases += " \\\n      '*:file:_files' ;;\n";
  }
  return "#compdef hgp\n_hgp() {\n  local -a commands=(\n" + list +
         "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
         "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $command in\n" +
         cases + "  esac\n}\n_hgp \"$@\"\n";
}

std::string fishScript(const std::vector<const CLI::App*>& commands) {
  std::string out = "# fish completion of hgp\n";
  const auto quoted = [](const std::string& text) { return escapedFor(text, "'\\", "\\"); };
  for (const CLI::App* command : commands)
    out += "complete -c hgp -n __fish_use_subcommand -a " + command->get_name() + " -d '" +
           quoted(command->get_description()) + "'\n";
  for (const CLI::App* command : commands)
    for (const CLI::Option* option : optionsOf(*command)) {
      out += "complete -c hgp -n '__fish_seen_subcommand_from " + command->get_name() + "' -l " +
             option->get_lnames().front();
      for (const std::string& name : option->get_snames()) out += " -s " + name;
      if (takesValue(*option)) out += " -r";
      out += " -d '" + quoted(option->get_description()) + "'\n";
    }
  return out;
}

}  // namespace

std::string manualPage(const CLI::App& app, const std::string& version) {
  std::string out = ".TH HGP 1 \"\" \"hgp " + roff(version) + "\"\n.SH NAME\nhgp \\- " +
                    roff(app.get_description()) + "\n.SH SYNOPSIS\n";
  for (const CLI::App* command : commandsOf(app))
    out += ".B hgp " + command->get_name() + "\n[\\fIOPTIONS\\fR] \\fIMESH\\fR\n.br\n";
  for (const CLI::App* command : commandsOf(app)) {
    out += ".SH HGP " + command->get_name() + "\n" + roff(command->get_description()) + "\n";
    describeOptions(*command, out);
  }
  return out + ".SH EXIT STATUS\n" + roff(app.get_footer()) + "\n";
}

std::string completionScript(const CLI::App& app, const std::string& shell) {
  const auto commands = commandsOf(app);
  if (shell == "bash") return bashScript(commands);
  if (shell == "zsh") return zshScript(commands);
  if (shell == "fish") return fishScript(commands);
  return "";
}

}  // namespace hgp::cli
