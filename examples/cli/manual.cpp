#include "manual.h"

#include <CLI/CLI.hpp>

#include "option_table.h"

namespace hgp::cli {
namespace {

std::vector<const CLI::App*> commandsOf(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// Options with long names, in the order of --help; --help itself is left out.
std::vector<const CLI::Option*> optionsOf(const CLI::App& app) {
  std::vector<const CLI::Option*> options;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_lnames().empty() && option != app.get_help_ptr()) options.push_back(option);
  return options;
}

bool takesValue(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

/// FILE, V:K, obj|off|ply …
std::string placeholderOf(const CLI::Option& option) {
  const std::string& text = option.get_option_text();
  return text == " " ? option.get_name(true) : text;
}

/// The words listed in an option's placeholder, separated by blanks; empty if it lists none.
/// Words in capitals are placeholders themselves.
std::string choicesOf(const CLI::Option& option) {
  const std::string text = placeholderOf(option);
  std::string out;
  for (const std::string& word : CLI::detail::split(text, '|')) {
    if (text.find('|') == std::string::npos || word.empty()) continue;
    if (word.front() >= 'A' && word.front() <= 'Z') continue;
    out += (out.empty() ? "" : " ") + word;
  }
  return out;
}

bool takesFile(const CLI::Option& option) { return placeholderOf(option) == "FILE"; }
bool takesFolder(const CLI::Option& option) { return placeholderOf(option) == "DIR"; }

std::string escapedFor(const std::string& text, const std::string& special,
                       const std::string& escape) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) out += escape;
    out += c;
  }
  return out;
}

std::string inCapitals(std::string word) {
  for (char& c : word)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return word;
}

/// Escapes text for man(7): backslashes, hyphens, and lines that look like requests.
std::string roff(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isAtStart = i == 0 || text[i - 1] == '\n';
    if (isAtStart && (text[i] == '.' || text[i] == '\'')) out += "\\&";
    if (text[i] == '\\')
      out += "\\e";
    else if (text[i] == '-')
      out += "\\-";
    else
      out += text[i];
  }
  return out;
}

void describeOption(const CLI::Option& option, std::string& out) {
  out += ".TP\n";
  for (const std::string& name : option.get_snames()) out += "\\fB\\-" + roff(name) + "\\fR, ";
  for (std::size_t i = 0; i < option.get_lnames().size(); ++i)
    out += (i > 0 ? ", " : "") + ("\\fB\\-\\-" + roff(option.get_lnames()[i])) + "\\fR";
  if (takesValue(option)) out += " \\fI" + roff(placeholderOf(option)) + "\\fR";
  out += "\n" + roff(option.get_description()) + "\n";
}

/// A command's synopsis, options by group, and examples.
void describeCommand(const CLI::App& command, std::string& out) {
  out +=
      ".SH HGP " + inCapitals(command.get_name()) + "\n" + roff(command.get_description()) + ".\n";
  for (const std::string& group : command.get_groups()) {
    bool isFirst = true;
    for (const CLI::Option* option : optionsOf(command)) {
      if (option->get_group() != group) continue;
      if (isFirst) out += ".SS " + roff(group) + "\n";
      isFirst = false;
      describeOption(*option, out);
    }
  }
  const std::string footer = command.get_footer();
  const std::size_t first = footer.find('\n');
  if (first != std::string::npos)
    out += ".SS Examples\n.nf\n" + roff(footer.substr(first + 1)) + "\n.fi\n";
}

std::string synopsisOf(const CLI::App& command) {
  std::string out = "\\fBhgp " + command.get_name() + "\\fR";
  if (!optionsOf(command).empty()) out += " [\\fIOPTIONS\\fR]";
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    const std::string name = "\\fI" + roff(option->get_name(true)) + "\\fR";
    out += " " + (option->get_required() ? name : "[" + name + "]");
  }
  return out + "\n.br\n";
}

/// Possible values of this option, as a completion action of bash.
std::string bashAction(const CLI::Option& option) {
  const std::string choices = choicesOf(option);
  if (!choices.empty()) return "COMPREPLY=($(compgen -W '" + choices + "' -- \"$current\"))";
  if (takesFile(option)) return "COMPREPLY=($(compgen -f -- \"$current\"))";
  if (takesFolder(option)) return "COMPREPLY=($(compgen -d -- \"$current\"))";
  return "COMPREPLY=()";
}

std::string bashScript(const std::vector<const CLI::App*>& commands) {
  std::string names, words, values;
  for (const CLI::App* command : commands) {
    names += command->get_name() + " ";
    std::string list = "--help";
    for (const CLI::Option* option : optionsOf(*command)) {
      list += " --" + option->get_lnames().front();
      if (!takesValue(*option)) continue;
      std::string pattern;
      for (const std::string& name : option->get_snames())
        pattern += command->get_name() + ":-" + name + "|";
      pattern += command->get_name() + ":--" + option->get_lnames().front();
      values += "    " + pattern + ") " + bashAction(*option) + "; return ;;\n";
    }
    words += "    " + command->get_name() + ") words=\"" + list + "\" ;;\n";
  }
  const std::string shells =
      "    completion) COMPREPLY=($(compgen -W 'bash zsh fish' -- \"$current\")); return ;;\n";
  return "# bash completion of hgp\n_hgp() {\n"
         "  local current=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
         "  local command=\"${COMP_WORDS[1]}\" names=\"" +
         names +
         "\" words=\"\"\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W \"$names --help --version\" -- \"$current\"))\n    return\n  "
         "fi\n"
         "  case \"$command:$before\" in\n" +
         values +
         "  esac\n  case \"$command\" in\n    help) COMPREPLY=($(compgen -W \"$names\" -- "
         "\"$current\")); return ;;\n" +
         shells + words +
         "  esac\n  case \"$current\" in\n"
         "    -*) COMPREPLY=($(compgen -W \"$words\" -- \"$current\")) ;;\n"
         "    *) COMPREPLY=($(compgen -f -- \"$current\")) ;;\n  esac\n}\n"
         "complete -o filenames -F _hgp hgp\n";
}

/// The message and action of a value for zsh's _arguments.
std::string zshAction(const CLI::Option& option) {
  const std::string choices = choicesOf(option);
  const std::string message = escapedFor(placeholderOf(option), "[]:", "\\");
  if (!choices.empty()) return ":" + message + ":(" + choices + ")";
  if (takesFile(option)) return ":" + message + ":_files";
  if (takesFolder(option)) return ":" + message + ":_files -/";
  return ":" + message + ": ";
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
      cases += takesValue(*option) ? zshAction(*option) + "'" : "'";
    }
    cases += command->get_name() == "completion" ? " \\\n      ':shell:(bash zsh fish)' ;;\n"
                                                 : " \\\n      '*:file:_files' ;;\n";
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
    out += "complete -c hgp -n __fish_use_subcommand -f -a " + command->get_name() + " -d '" +
           quoted(command->get_description()) + "'\n";
  out += "complete -c hgp -n '__fish_seen_subcommand_from completion' -f -a 'bash zsh fish'\n";
  for (const CLI::App* command : commands)
    for (const CLI::Option* option : optionsOf(*command)) {
      out += "complete -c hgp -n '__fish_seen_subcommand_from " + command->get_name() + "' -l " +
             option->get_lnames().front();
      for (const std::string& name : option->get_snames()) out += " -s " + name;
      const std::string choices = choicesOf(*option);
      if (!choices.empty())
        out += " -x -a '" + choices + "'";
      else if (takesValue(*option))
        out += takesFile(*option) || takesFolder(*option) ? " -r" : " -x";
      out += " -d '" + quoted(option->get_description()) + "'\n";
    }
  return out;
}

}  // namespace

std::string manualPage(const CLI::App& app, const std::string& version) {
  std::string out = ".TH HGP 1 \"2026-11-24\" \"hgp " + roff(version) +
                    "\" \"\"\n.SH NAME\nhgp \\- " + roff(app.get_description()) +
                    "\n.SH SYNOPSIS\n";
  for (const CLI::App* command : commandsOf(app)) out += synopsisOf(*command);
  for (const CLI::App* command : commandsOf(app)) describeCommand(*command, out);
  return out + ".SH EXIT STATUS\n.nf\n" + roff(exitCodeText()) +
         "\n.fi\n.SH ENVIRONMENT\n.TP\n\\fBNO_COLOR\\fR\nNo colour, unless \\fB\\-\\-color "
         "always\\fR is given.\n.TP\n\\fBTERM\\fR\n\\fBdumb\\fR: no colour, and plain lines of "
         "progress.\n";
}

std::string completionScript(const CLI::App& app, const std::string& shell) {
  const auto commands = commandsOf(app);
  if (shell == "bash") return bashScript(commands);
  if (shell == "zsh") return zshScript(commands);
  if (shell == "fish") return fishScript(commands);
  return "";
}

}  // namespace hgp::cli
