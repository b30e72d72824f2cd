#pragma once

#include <string>
#include <string_view>

namespace abrazo {

/// Elements of one picture, in user units of about a pixel. All text given is escaped here.
class SvgCanvas {
 public:
  SvgCanvas(double width, double height, std::string_view title);

  enum class Anchor { Start, Middle, End };
  struct TextStyle {
    Anchor anchor = Anchor::Start;
    std::string_view colour = "var(--ink,#1c1c1c)";
    double size = 12;
    bool bold = false;
    bool upwards = false;  ///< turned by -90 degrees about its place
  };

  void text(double x, double y, std::string_view content, const TextStyle& style);
  void line(double x1, double y1, double x2, double y2, std::string_view colour, double width = 1,
            std::string_view dashes = "");
  /// @param style  CSS: fill and so on
  void rectangle(double x, double y, double width, double height, std::string_view style,
                 std::string_view tooltip = "");
  /// @param points  "x,y x,y ..."
  void polyline(const std::string& points, std::string_view colour, std::string_view dashes);
  /// A data point: `shape` 0 circle, 1 square, 2 triangle, 3 diamond, and again.
  void marker(double x, double y, int shape, std::string_view colour, std::string_view tooltip);

  std::string finish() const;

 private:
  std::string head_, body_;
};

inline constexpr std::string_view ink_colour = "var(--ink,#1c1c1c)";
inline constexpr std::string_view muted_colour = "var(--muted,#666)";
inline constexpr std::string_view grid_colour = "var(--grid,#ddd)";
inline constexpr std::string_view reference_colour = "var(--reference,#777)";

/// Colour of the n-th series, n from 0.
std::string series_colour(int n);

/// About how wide a text is in the pictures' sans-serif face.
double text_width(std::string_view text, double size);

/// The text, shortened with an ellipsis if it does not fit.
std::string fitted(std::string_view text, double width, double size);

/// A coordinate with as many digits as a picture needs.
std::string coordinate(double value);

}  // namespace abrazo
