#include "io/cloud/chemical_elements.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "io/words.h"

namespace rbpa::app {
namespace {

/// The elements by their atomic numbers, from 1, and hydrogen's isotopes, with radii of source_of_radius(). Platinum
/// has 1.72 in Bondi's table XIV.
constexpr Element known_elements[] = {
    {"H", 1.20},  {"He", 1.40}, {"Li", 1.82}, {"Be", 1.53}, {"B", 1.92},  {"C", 1.70},  {"N", 1.55},  {"O", 1.52},
    {"F", 1.47},  {"Ne", 1.54}, {"Na", 2.27}, {"Mg", 1.73}, {"Al", 1.84}, {"Si", 2.10}, {"P", 1.80},  {"S", 1.80},
    {"Cl", 1.75}, {"Ar", 1.88}, {"K", 2.75},  {"Ca", 2.31}, {"Sc", 2.58}, {"Ti", 2.46}, {"V", 2.42},  {"Cr", 2.45},
    {"Mn", 2.45}, {"Fe", 2.44}, {"Co", 2.40}, {"Ni", 1.63}, {"Cu", 1.40}, {"Zn", 1.39}, {"Ga", 1.87}, {"Ge", 2.11},
    {"As", 1.85}, {"Se", 1.90}, {"Br", 1.85}, {"Kr", 2.02}, {"Rb", 3.03}, {"Sr", 2.49}, {"Y", 2.75},  {"Zr", 2.52},
    {"Nb", 2.56}, {"Mo", 2.45}, {"Tc", 2.44}, {"Ru", 2.46}, {"Rh", 2.44}, {"Pd", 1.63}, {"Ag", 1.72}, {"Cd", 1.58},
    {"In", 1.93}, {"Sn", 2.17}, {"Sb", 2.06}, {"Te", 2.06}, {"I", 1.98},  {"Xe", 2.16}, {"Cs", 3.43}, {"Ba", 2.68},
    {"La", 2.98}, {"Ce", 2.88}, {"Pr", 2.92}, {"Nd", 2.95}, {"Pm", 0},    {"Sm", 2.90}, {"Eu", 2.87}, {"Gd", 2.83},
    {"Tb", 2.79}, {"Dy", 2.87}, {"Ho", 2.81}, {"Er", 2.83}, {"Tm", 2.79}, {"Yb", 2.80}, {"Lu", 2.74}, {"Hf", 2.63},
    {"Ta", 2.53}, {"W", 2.57},  {"Re", 2.49}, {"Os", 2.48}, {"Ir", 2.41}, {"Pt", 1.72}, {"Au", 1.66}, {"Hg", 1.55},
    {"Tl", 1.96}, {"Pb", 2.02}, {"Bi", 2.07}, {"Po", 1.97}, {"At", 2.02}, {"Rn", 2.20}, {"Fr", 3.48}, {"Ra", 2.83},
    {"Ac", 2.80}, {"Th", 2.93}, {"Pa", 2.88}, {"U", 1.86},  {"Np", 2.82}, {"Pu", 2.81}, {"Am", 2.83}, {"Cm", 3.05},
    {"Bk", 3.40}, {"Cf", 3.05}, {"Es", 2.70}, {"Fm", 0},    {"Md", 0},    {"No", 0},    {"Lr", 0},    {"D", 1.20},
    {"T", 1.20}};
constexpr std::size_t isotopes = 2;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

std::string_view symbol_of(std::string_view word) {
  const Element* const found = find_element(word);
  return found == nullptr ? std::string_view() : found->symbol;
}

/// Returns the element of the name of an atom. `begins` is the column of PDB where the name begins, 13 or 14, or 0 if
/// the file does not tell.
std::string_view element_of_name(std::string_view name, std::string_view residue, std::size_t begins) {
  const auto* const first = std::find_if(name.begin(), name.end(), is_letter);
  const std::string_view word(first, static_cast<std::size_t>(std::find_if_not(first, name.end(), is_letter) - first));
  if (word.empty()) return {};
  const std::string_view one = symbol_of(word.substr(0, 1));
  const std::string_view two = word.size() < 2 ? std::string_view() : symbol_of(word.substr(0, 2));
  const std::string_view likely = one.empty() ? two : one;
  constexpr std::string_view nucleotides = "A C G U I T DA DC DG DT DU DI ADE CYT GUA THY URA";
  // Beads of coarse models have names like BB and SC1, which are no boron and no sulfur.
  if (is_amino_acid(residue))
    return is_word_of(likely, "H D C N O P Se") || (likely == "S" && is_word_of(residue, "CYS CYX CYM MET"))
               ? likely
               : std::string_view();
  if (is_word_of(residue, nucleotides) || is_digit(name.front())) return likely;  // 1HB
  // Ions of CHARMM have the names of their residues.
  constexpr std::string_view ions[][2] = {{"SOD", "Na"}, {"POT", "K"},  {"CLA", "Cl"}, {"CAL", "Ca"}, {"CES", "Cs"},
                                          {"LIT", "Li"}, {"RUB", "Rb"}, {"BAR", "Ba"}, {"CAD", "Cd"}};
  for (const auto& [ion, symbol] : ions)
    if (name == ion && residue == ion) return symbol;
  if (two.empty()) return likely;
  // Other ions, too, have the names of their residues, also in the wrong column of PDB: NA, CU1.
  const bool is_ion = word.size() == 2 && same_letters(residue.substr(0, 2), word) &&
                      std::none_of(residue.begin() + 2, residue.end(), is_letter);
  if (begins == 14 && !is_ion) return likely;
  const bool is_mixed = std::islower(static_cast<unsigned char>(word[1])) != 0;
  if (is_ion || is_mixed || is_word_of(two, "Cl Br Si Se") || (begins == 13 && name.size() < 4)) return two;
  // The first letter is the element of C12A and HG11, but F is not the element of FE.
  return is_word_of(one, "H D C N O P S") || (word.size() > 2 && !one.empty()) ? one : two;
}

}  // namespace

const Element* find_element(std::string_view symbol) {
  const auto* const behind = std::find_if_not(symbol.begin(), symbol.end(), is_letter);
  if (!std::all_of(behind, symbol.end(), [](char c) { return is_digit(c) || c == '+' || c == '-'; })) return nullptr;
  const std::string_view word = symbol.substr(0, static_cast<std::size_t>(behind - symbol.begin()));
  const auto* const found = std::find_if(std::begin(known_elements), std::end(known_elements),
                                         [&](const Element& element) { return same_letters(element.symbol, word); });
  return found == std::end(known_elements) ? nullptr : found;
}

std::string_view source_of_radius(std::string_view symbol) {
  if (is_word_of(symbol, "Be B Al Ca Ge Rb Sr Sb Cs Ba Bi Po At Rn Fr Ra")) return "Mantina";
  return is_word_of(symbol,
                    "Sc Ti V Cr Mn Fe Co Y Zr Nb Mo Tc Ru Rh La Ce Pr Nd Sm Eu Gd Tb Dy Ho Er Tm Yb Lu Hf Ta W Re Os "
                    "Ir Ac Th Pa Np Pu Am Cm Bk Cf Es")
             ? "Alvarez"
             : "Bondi";
}

std::string_view element_of(const Atom& atom) {
  const std::string& field = atom.fields[AtomColumn::element];
  // X stands for an unknown element; so do the names of atoms of unknown residues.
  if (is_word_of(field, "X Xx") || (field.empty() && is_word_of(atom.fields[AtomColumn::resname], "UNK UNX") &&
                                    atom.fields[AtomColumn::name].starts_with("UN")))
    return {};
  if (const std::string_view symbol = symbol_of(field); !symbol.empty()) return symbol;
  const std::optional<std::size_t> number = parse_count(field);
  if (number && *number >= 1 && *number <= std::size(known_elements) - isotopes && atom.name_begins == 0)
    return known_elements[*number - 1].symbol;
  return element_of_name(atom.fields[AtomColumn::name], atom.fields[AtomColumn::resname], atom.name_begins);
}

bool is_amino_acid(std::string_view residue) {
  return is_word_of(
      residue,
      "ALA ARG ASN ASP CYS GLN GLU GLY HIS ILE LEU LYS MET PHE PRO SER THR TRP TYR VAL ASX GLX HID HIE HIP "
      "HSD HSE HSP CYX CYM ASH GLH LYN");
}

}  // namespace rbpa::app
