#include "app/workbench/keys/help_window.hpp"

#include <QDesktopServices>
#include <QDirIterator>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "app/workbench/base/dialog_size.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/qt_versions.hpp"
#include "widgets/common/theme.hpp"

/// Outside any namespace, as Qt asks for resources in a library.
static void load_guide() {
  Q_INIT_RESOURCE(guide);
}

namespace abrazo::app {
namespace {

constexpr int page_role = Qt::UserRole;
constexpr int list_width = 230;
constexpr int typing_pause_ms = 200;
const char* const keys_address = "abrazo:keys";

/// As in links to a heading: "By keys" is "by-keys".
QString heading_link(const QString& heading) {
  QString link;
  for (const QChar c : heading.toLower())
    if (c.isLetterOrNumber() || c == '-' || c == '_')
      link += c;
    else if (c == ' ')
      link += '-';
  return link;
}

/// The overview of the window comes first, which a person in it looks for, then that of the guide, which
/// begins with the installation.
int place_of_page(const QString& address) {
  if (address == "qrc:/docs/guide/workbench.md") return 0;
  if (address == "qrc:/docs/guide/index.md") return 1;
  if (address.startsWith("qrc:/docs/guide/workbench/")) return 2;
  if (!address.startsWith("qrc:/docs/guide/")) return 5;
  // What a person in the window does comes before commands and programming.
  constexpr std::array for_the_window = {"annotation", "export", "intent",      "labels",  "live",
                                         "projects",   "live/",  "suggestions", "trouble", "video"};
  const QString page = address.mid(static_cast<int>(std::size("qrc:/docs/guide/")) - 1).remove(".md");
  const bool is_for_window = std::ranges::any_of(for_the_window, [&](const char* each) {
    return QString(each).endsWith('/') ? page.startsWith(each) : page == each;
  });
  return is_for_window ? 3 : 4;
}

}  // namespace

/// A page of the guide; pictures are as wide as the page at most, tables have thin lines.
class HelpPage : public QTextBrowser {
 public:
  explicit HelpPage(QWidget* parent) : QTextBrowser(parent) {
    connect(this, &QTextBrowser::sourceChanged, this, &HelpPage::dressTables);
  }

  void open(const QUrl& to) {
    if (to.scheme().startsWith("http")) return void(QDesktopServices::openUrl(to));
    QUrl page = to;
    page.setFragment({});
    if (page != source()) setSource(page);
    if (to.hasFragment()) goTo(to.fragment());
  }

  void setKeys(const QString& html) {
    m_keys = html;
    if (source() == QUrl(keys_address)) reload();
  }

  QVariant loadResource(int type, const QUrl& name) override {
    if (name == QUrl(keys_address)) return m_keys;
    QVariant found = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource) return found;
    const QImage picture = QImage::fromData(found.toByteArray());
    const int room = viewport()->width() - 40;
    return picture.width() > room ? picture.scaledToWidth(room, Qt::SmoothTransformation) : picture;
  }

 private:
  QString m_keys;

  /// By default every cell has a bright frame of its own.
  void dressTables() {
    QColor line = palette().color(QPalette::Text);
    line.setAlphaF(widgets::colour_part(0.2));
    for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
      auto* table = qobject_cast<QTextTable*>(frame);
      if (!table) continue;
      QTextTableFormat format = table->format();
      format.setBorder(1);
      format.setBorderBrush(line);
      format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
      format.setBorderCollapse(true);
      format.setCellPadding(5);
      format.setCellSpacing(0);
      table->setFormat(format);
    }
  }

  void goTo(const QString& heading) {
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
      if (block.blockFormat().headingLevel() == 0 || heading_link(block.text()) != heading) continue;
      // To the end first, so that the heading is at the top of the view.
      moveCursor(QTextCursor::End);
      setTextCursor(QTextCursor(block));
      return;
    }
  }
};

HelpWindow::HelpWindow(QWidget* parent)
    : QDialog(parent),
      m_field(new QLineEdit(this)),
      m_list(new QListWidget(this)),
      m_page(new HelpPage(this)) {
  setObjectName("Help");
  setWindowTitle("Help");
  resize_within_screen(*this, {980, 720});
  m_field->setPlaceholderText("Search the guide");
  m_field->setAccessibleName("Search the guide");
  m_field->setClearButtonEnabled(true);
  m_list->setAccessibleName("Pages of the guide");
  m_list->setFrameShape(QFrame::NoFrame);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // a long title ends with "…"
  m_page->setAccessibleName("Page of the guide");
  m_page->setFrameShape(QFrame::NoFrame);
  m_page->setOpenLinks(false);
  m_page->document()->setDocumentMargin(16);
  m_page->setFont(widgets::interface_font(13));
  auto* back = new QPushButton("Back", this);
  back->setAutoDefault(false);
  auto* left = new QVBoxLayout;
  left->addWidget(m_field);
  left->addWidget(m_list, 1);
  left->addWidget(back);
  m_field->setFixedWidth(list_width);
  m_list->setFixedWidth(list_width);
  auto* row = widgets::row_in(this, {12, 12, 0, 12});
  row->addLayout(left);
  row->addWidget(m_page, 1);
  readPages();
  back->setEnabled(false);
  connect(back, &QPushButton::clicked, m_page, &QTextBrowser::backward);
  connect(m_page, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(m_page, &QTextBrowser::anchorClicked, m_page,
          [this](const QUrl& to) { m_page->open(m_page->source().resolved(to)); });
  connect(m_field, &QLineEdit::textEdited, this, [this](const QString& typed) {
    {
      const QSignalBlocker later(m_list);
      search(typed);
    }
    m_soon.start();
  });
  m_soon.setSingleShot(true);
  m_soon.setInterval(typing_pause_ms);
  connect(&m_soon, &QTimer::timeout, this, [this] {
    if (const QListWidgetItem* item = m_list->currentItem()) showPage(item->data(page_role).toInt());
  });
  connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item) showPage(item->data(page_role).toInt());
  });
  connect(new QShortcut(QKeySequence("F1"), this), &QShortcut::activated, this, &QDialog::close);
  connect(this, &QDialog::finished, parent, [parent] { parent->activateWindow(); });
  search({});
  m_field->setFocus();
}

void HelpWindow::readPages() {
  load_guide();
  m_pages.push_back({"Keys", keys_address, {}});
  for (QDirIterator files(":/docs", {"*.md"}, QDir::Files, QDirIterator::Subdirectories); files.hasNext();) {
    QFile file(files.next());
    if (!file.open(QIODevice::ReadOnly)) continue;
    const QString words = QString::fromUtf8(file.readAll());
    m_pages.push_back(
        {words.section('\n', 0, 0).remove("# ").remove('`').trimmed(), "qrc" + file.fileName(), words});
  }
  std::sort(m_pages.begin() + 1, m_pages.end(), [](const Page& a, const Page& b) {
    const int first = place_of_page(a.address), second = place_of_page(b.address);
    return first != second ? first < second : a.title.compare(b.title, Qt::CaseInsensitive) < 0;
  });
}

void HelpWindow::setKeys(const QString& html) {
  m_page->setKeys(html);
  m_pages.front().words = html;
}

QStringList HelpWindow::listed() const {
  QStringList titles;
  for (int row = 0; row < m_list->count(); ++row) titles << m_list->item(row)->text();
  return titles;
}

void HelpWindow::search(const QString& typed) {
  constexpr int in_title = 20;
  if (m_field->text() != typed) m_field->setText(typed);
  const QStringList words = typed.split(' ', Qt::SkipEmptyParts);
  std::vector<std::pair<int, int>> found;  // hits, page
  for (int page = 0; page < static_cast<int>(m_pages.size()); ++page) {
    const Page& each = m_pages[static_cast<std::size_t>(page)];
    int hits = 0;
    bool has_all = true;
    for (const QString& word : words) {
      const int here = static_cast<int>(each.words.count(word, Qt::CaseInsensitive)) +
                       (each.title.contains(word, Qt::CaseInsensitive) ? in_title : 0);
      has_all = has_all && here > 0;
      hits += here;
    }
    if (has_all) found.emplace_back(hits, page);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  m_list->clear();
  for (const auto& [hits, page] : found) {
    auto* item = new QListWidgetItem(m_pages[static_cast<std::size_t>(page)].title, m_list);
    item->setData(page_role, page);
  }
  if (m_list->count() > 0) m_list->setCurrentRow(typed.isEmpty() && m_list->count() > 1 ? 1 : 0);
}

void HelpWindow::showAbout(const QString& page) {
  const QString address = "qrc:/docs/" + page;
  const auto found = std::ranges::find(m_pages, address, &Page::address);
  if (found == m_pages.end()) return;
  search({});
  m_list->setCurrentRow(static_cast<int>(found - m_pages.begin()));
}

void HelpWindow::showPage(int page) {
  m_soon.stop();
  m_page->open(m_pages[static_cast<std::size_t>(page)].address);
  mark();
}

/// Every place of the first word, and the first of them is in view.
void HelpWindow::mark() {
  const QString word = m_field->text().section(' ', 0, 0, QString::SectionSkipEmpty);
  QList<QTextEdit::ExtraSelection> marks;
  if (!word.isEmpty())
    for (QTextCursor at = m_page->document()->find(word); !at.isNull();
         at = m_page->document()->find(word, at)) {
      QTextEdit::ExtraSelection mark;
      mark.cursor = at;
      mark.format.setBackground(palette().highlight());
      mark.format.setForeground(palette().highlightedText());
      marks << mark;
    }
  m_page->setExtraSelections(marks);
  if (marks.isEmpty()) return;
  QTextCursor first = marks.front().cursor;
  first.clearSelection();
  m_page->setTextCursor(first);
}

}  // namespace abrazo::app
