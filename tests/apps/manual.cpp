// Manual pages and completions agree with --help.
#include <doctest/doctest.h>

#include <cstdlib>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/program.h"

using namespace apps_test;

namespace {

const std::vector<std::string> programs = {"rbpa", "meshtopo"};

/// Returns every option that begins a line of the help.
std::set<std::string> options_in(const std::string& help) {
  const std::regex line("\n  (-[a-z]),(--[a-z-]+)|\n  (-[a-z-]+)");
  std::set<std::string> found;
  for (auto m = std::sregex_iterator(help.begin(), help.end(), line); m != std::sregex_iterator(); ++m)
    for (std::size_t group = 1; group < m->size(); ++group)
      if ((*m)[group].matched) found.insert((*m)[group]);
  return found;
}

Outcome ask(const Folder& folder, const std::string& program, const std::string& arguments) {
  return program == "rbpa" ? folder.rbpa(arguments) : folder.meshtopo(arguments);
}

std::set<std::string> all_options(const Folder& folder, const std::string& program) {
  std::set<std::string> all = options_in(ask(folder, program, "--help").out);
  if (program == "rbpa")
    for (const std::string verb : {"mesh", "alpha", "shape", "stream", "info"})
      all.merge(options_in(folder.rbpa(verb + " --help").out));
  return all;
}

/// Returns the completions of bash for these words, the last of which is incomplete.
std::string completed(const Folder& folder, const std::string& program, const std::string& words) {
  folder.file("ask.sh", "source ./script\nCOMP_WORDS=(" + words + ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_" +
                            program + "\nprintf '%s ' \"${COMPREPLY[@]}\"\n");
  return folder.run("bash", "ask.sh").out;
}

}  // namespace

TEST_SUITE("manual") {
  TEST_CASE("every option of every help is in the manual page and in both completions") {
    const Folder folder;
    for (const std::string& program : programs) {
      CAPTURE(program);
      const std::set<std::string> options = all_options(folder, program);
      CHECK(options.size() > 8);
      CHECK(options.contains("--completion"));
      CHECK(options.contains("-q"));
      const std::string page = ask(folder, program, "--man").out;
      const std::string bash = ask(folder, program, "--completion bash").out;
      const std::string zsh = ask(folder, program, "--completion zsh").out;
      for (const std::string& option : options) {
        CAPTURE(option);
        const std::string in_roff = std::regex_replace(option, std::regex("-"), "\\-");
        CHECK(contains(page, "\\fB" + in_roff + "\\fR"));
        CHECK(std::regex_search(bash, std::regex("[' ]" + option + "[' ]")));
        CHECK(std::regex_search(zsh, std::regex("'\\*" + option + "=?\\[")));
      }
    }
  }

  TEST_CASE("a manual page gives no warnings in groff, and shows texts as they are") {
    const Folder folder;
    for (const std::string& program : programs) {
      folder.file("page", ask(folder, program, "--man").out);
      const Outcome shown = folder.run("groff", "-man -Tascii -P-c -P-b -P-u -ww page");
      if (shown.code == 127) continue;  // no groff on this machine
      CHECK(shown.err.empty());
      CHECK(contains(shown.out, "EXIT STATUS"));
      CHECK(contains(shown.out, program == "rbpa" ? "rbpa mesh points.xy --alpha 0.3 -o mesh.ply -o picture.png"
                                                  : "meshtopo part.stl --json -o report.json"));
    }
  }

  TEST_CASE("bash completes verbs and the options of a verb") {
    const Folder folder;
    folder.file("script", folder.rbpa("--completion bash").out);
    CHECK(completed(folder, "rbpa", "rbpa m") == "mesh ");
    CHECK(completed(folder, "rbpa", "rbpa --v") == "--version ");
    CHECK(completed(folder, "rbpa", "rbpa mesh points.xy --alpha-i") == "--alpha-inverse ");
    CHECK(!contains(completed(folder, "rbpa", "rbpa info --lev"), "--levels"));
    CHECK(completed(folder, "rbpa", "rbpa mesh --lev") == "--levels ");
    folder.file("script", folder.meshtopo("--completion bash").out);
    CHECK(completed(folder, "meshtopo", "meshtopo --rep") == "--repair ");
  }

  TEST_CASE("the title names plane and space; verbs have a line each, and a description of their own") {
    const Folder folder;
    const std::string help = folder.rbpa("help").out, title = help.substr(0, help.find('\n'));
    CHECK(title == "Outlines and triangles of points in the plane, surfaces and solids of points in space");
    CHECK(contains(folder.rbpa("--man").out, ".SH NAME\nrbpa \\- " + title + "\n"));
    CHECK(contains(help,
                   "  shape                       Make polygons with holes of the alpha solid, valid under OGC Simple\n"
                   "                              Features\n"
                   "  discs  "));
    CHECK(contains(folder.rbpa("--completion zsh").out,
                   "'shape:Make polygons with holes of the alpha solid, valid under OGC Simple Features'"));
  }

  TEST_CASE(
      "help shape begins with which alpha to choose: plateau first; so does its example, and --cover comes last") {
    const Folder folder;
    const std::string help = folder.rbpa("help shape").out;
    const auto at = [&](const std::string& word) {
      const std::size_t place = help.find(word);
      CHECK_MESSAGE(place != std::string::npos, word);
      return place;
    };
    CHECK(at("Which alpha to choose: plateau first.") < at("Usage: "));
    CHECK(at("with --cover 0.99 they leave") < at("may then have many parts and pinholes"));
    CHECK(at("may then have many parts and pinholes") < at("Usage: "));
    CHECK(at("--alpha plateau -o") < at("--alpha auto --cover 0.99 "));
    CHECK(help.find("rbpa shape") == at("rbpa shape [OPTIONS]"));
    CHECK(help.find("  rbpa shape") == at("  rbpa shape points.xy --alpha plateau"));
    CHECK(contains(folder.rbpa("--man").out, "Which alpha to choose: plateau first."));
  }

  TEST_CASE("the help of --where has a condition on texts, that of surface --columns the names of colors; both hold") {
    const Folder folder("p.csv", "x,y,z,r,g,b,group\n0,0,0,9,8,7,A\n1,0,0,9,8,7,B\n0,1,0,9,8,7,A\n5,5,5,9,8,7,C\n");
    const auto words = [](std::string text) {  // on one line, blanks once
      text = std::regex_replace(text, std::regex("\\s+"), " ");
      return text;
    };
    const std::string condition = "group in ('A', 'B')", colors = "that the header calls red, green and blue, or r, g";
    for (const std::string verb : {"info", "mesh", "shape", "alpha", "stream", "surface"}) {
      CAPTURE(verb);
      CHECK(contains(words(folder.rbpa("help " + verb).out), "or for texts \"" + condition + "\""));
    }
    CHECK(contains(words(folder.rbpa("help surface").out), colors));
    CHECK(folder.rbpa("info p.csv --where \"" + condition + "\"").out.starts_with("points      3\n"));
    REQUIRE(folder.rbpa("surface p.csv --columns x,y,z --radius 5 --where \"" + condition + "\" -o s.ply -q").code ==
            0);
    CHECK(contains(folder.content("s.ply"), "property uchar red"));
  }

  TEST_CASE("help VERB is the same as VERB --help") {
    const Folder folder;
    CHECK(folder.rbpa("help").out == folder.rbpa("--help").out);
    CHECK(folder.rbpa("help shape").out == folder.rbpa("shape --help").out);
    CHECK(contains(folder.rbpa("help shape").out, "--min-hole-area"));
    says(folder, "help mehs", 2, "found 'mehs'");
  }

  TEST_CASE("an unknown shell is refused by name") {
    const Folder folder;
    for (const std::string& program : programs) {
      const Outcome fish = ask(folder, program, "--completion fish");
      CHECK(fish.code == 2);
      CHECK(contains(fish.err, "--completion: found 'fish', expected bash or zsh"));
    }
  }
}
