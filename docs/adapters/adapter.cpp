// Line protocol of `python -m tools.grade --command ./student`, for the functions in student.hpp.
// Build: g++ -std=c++17 -O2 -o student adapter.cpp
// Delete the line of a function that you do not have.
#include <cmath>
#include <complex>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>
using Point = std::complex<double>;
using Polar = std::pair<double, double>;  // radius, angle
using Numbers = std::vector<double>;
#include "student.hpp"

std::string text(double x) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.17g", x);
    return std::isfinite(x) ? digits : "\"not finite\"";
}
std::string text(bool b) { return b ? "true" : "false"; }
std::string text(const std::string& s) { return '"' + s + '"'; }
std::string text(Point p) { return "[" + text(p.real()) + ", " + text(p.imag()) + "]"; }
std::string text(Polar p) { return "[" + text(p.first) + ", " + text(p.second) + "]"; }
std::string text(std::optional<Point> p) { return p ? text(*p) : "null"; }
const std::map<std::string, std::function<std::string(const Numbers&)>> functions = {
    {"normalize_angle", [](auto& a) { return text(normalize_angle(a[0])); }},
    {"add_angles", [](auto& a) { return text(add_angles(a[0], a[1])); }},
    {"subtract_angles", [](auto& a) { return text(subtract_angles(a[0], a[1])); }},
    {"min_difference", [](auto& a) { return text(min_difference(a[0], a[1])); }},
    {"on_left", [](auto& a) { return text(on_left(a[0], a[1])); }},
    {"to_polar", [](auto& a) { return text(to_polar({a[0], a[1]})); }},
    {"to_cartesian", [](auto& a) { return text(to_cartesian(a[0], a[1])); }},
    {"closest_point_on_line", [](auto& a) { return text(closest_point_on_line({a[0], a[1]}, {a[2], a[3]}, {a[4], a[5]})); }},
    {"broad_phase_outcome", [](auto& a) { return text(broad_phase_outcome({a[0], a[1]}, a[2], a[3], a[4], a[5], a[6], a[7])); }},
    {"broad_phase", [](auto& a) {
        std::vector<Polar> positions;
        for (size_t i = 6; i + 1 < a.size(); i += 2) positions.push_back({a[i], a[i + 1]});
        return text(broad_phase({a[0], a[1]}, a[2], a[3], positions, a[4], a[5])); }},
    {"narrow_phase_case_1", [](auto& a) { return text(narrow_phase_case_1({a[0], a[1]}, a[2])); }},
    {"narrow_phase_case_2", [](auto& a) { return text(narrow_phase_case_2({a[0], a[1]}, a[2], a[3], a[4], a[5], a[6], a[7])); }},
    {"collision_response", [](auto& a) { return text(collision_response({a[0], a[1]}, {a[2], a[3]}, {a[4], a[5]}, a[6], a[7])); }},
};

int main() {
    for (std::string line; std::getline(std::cin, line);) {  // {"function": "to_polar", "arguments": [3.0, 4.0]}
        const auto name = line.find("\"function\": \"") + 13;
        const auto found = functions.find(line.substr(name, line.find('"', name) - name));
        Numbers numbers;
        for (const char* at = line.c_str() + line.find('['); *at && *at != ']';) {
            char* end;
            numbers.push_back(std::strtod(at + 1, &end));
            at = end;
        }
        std::cout << (found == functions.end() ? "{\"undefined\": true}" : "{\"result\": " + found->second(numbers) + "}") << std::endl;
    }
}
