// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/canvas.h"

#include "core/input_error.h"

#include <vtkGL2PSExporter.h>
#include <vtkImageResize.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <unistd.h>

#include <array>
#include <fstream>
#include <iterator>
#include <string>

namespace encased_column {

namespace {

std::string find_font()
{
  for (const char* file :
       {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
        "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf"})
    if (std::filesystem::exists(file)) return file;
  return {};
}

/// VTK reports a file it cannot write only in its own log: look whether it is there instead.
void remove_old(const std::filesystem::path& file)
{
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
}

void replace_all(std::string& text, const std::string& old, const std::string& by)
{
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size())
    text.replace(at, old.size(), by);
}

std::string text_of(const std::filesystem::path& file)
{
  std::ifstream reading(file);
  return {std::istreambuf_iterator<char>(reading), {}};
}

/// GL2PS puts titles, which stand on their lower edge, on their baseline instead, so that the tails
/// of letters reach into what lies below; and names one font, which the layout is not made for.
void mend_text(const std::filesystem::path& svg)
{
  std::string text = text_of(svg);
  replace_all(text, "\"middle\" dy=\"0\"", "\"middle\" dy=\"-0.22em\"");
  replace_all(text, "\"Helvetica\"", "\"DejaVu Sans, Verdana, Helvetica, Arial, sans-serif\"");
  std::ofstream(svg) << text;
}

void check_written(const std::filesystem::path& file)
{
  if (!std::filesystem::exists(file))
    throw InputError("pictures must go where they can be written, found '" + file.string() +
                     "' refused, write for example '--output results'");
}

}  // namespace

void prepare_window(vtkRenderWindow* window, int width, int height, int samples)
{
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(samples);
  window->SetSize(width, height);
}

void set_font(vtkTextProperty* text, int size)
{
  static const std::string font = find_font();
  if (!font.empty()) {
    text->SetFontFamily(VTK_FONT_FILE);
    text->SetFontFile(font.c_str());
  }
  text->SetFontSize(size);
  text->SetBold(0);
  text->SetColor(0.1, 0.1, 0.1);
}

void write_png(const std::filesystem::path& file, vtkRenderWindow* window, int finer)
{
  const std::filesystem::path png = file.string() + ".png";
  remove_old(png);
  window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->SetInputBufferTypeToRGB();
  image->ReadFrontBufferOff();
  image->ShouldRerenderOff();
  image->Update();
  vtkNew<vtkPNGWriter> writer;
  vtkNew<vtkImageResize> smaller;
  if (finer > 1) {
    const std::array<int, 2> size{window->GetSize()[0], window->GetSize()[1]};
    smaller->SetInputConnection(image->GetOutputPort());
    smaller->SetOutputDimensions(size[0] / finer, size[1] / finer, 1);
    writer->SetInputConnection(smaller->GetOutputPort());
  } else
    writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(png.c_str());
  writer->Write();
  check_written(png);
}

void write_svg(const std::filesystem::path& file, vtkRenderWindow* window)
{
  const std::filesystem::path svg = file.string() + ".svg";
  remove_old(svg);
  // The exporter draws the pixels too, though no file has them: at four samples each that takes
  // most of its time.
  window->SetMultiSamples(0);
  vtkNew<vtkGL2PSExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->SetFileFormatToSVG();
  exporter->CompressOff();
  exporter->SetSortToOff();
  exporter->SilentOn();
  exporter->SetTitle(file.filename().c_str());
  exporter->SetFilePrefix(file.c_str());
  exporter->Write();
  check_written(svg);
  mend_text(svg);
}

std::string svg_elements(vtkRenderWindow* window)
{
  // The exporter knows files only.
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("encase_chart_" + std::to_string(getpid()));
  write_svg(file, window);
  const std::filesystem::path svg = file.string() + ".svg";
  std::string text = text_of(svg);
  std::filesystem::remove(svg);
  text.erase(0, text.find("<g>"));
  text.erase(text.rfind("</svg>"));
  for (const char* usual : {" stroke-dasharray=\"16,0\"", " stroke-linecap=\"butt\"",
                            " stroke-linejoin=\"miter\"", " font-weight=\"normal\""})
    replace_all(text, usual, "");
  return text;
}

}  // namespace encased_column
