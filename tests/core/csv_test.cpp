#include <QtTest>

#include "core/io/csv.h"

using namespace graftsman;

namespace {

std::string textOf(const std::vector<csv::Row>& rows) {
  std::string text;
  for (const csv::Row& row : rows) {
    csv::append(text, row);
  }
  return text;
}

}  // namespace

class CsvTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void plainCellsStandWithoutQuotes() {
    QCOMPARE(textOf({{"a", "b c", ""}, {"1.5", "", "ü"}}), std::string("a,b c,\r\n1.5,,ü\r\n"));
  }

  void commasQuotesAndLineBreaksAreQuoted() {
    QCOMPARE(textOf({{"0,0;1,1", "say \"no\"", "two\nlines"}}),
             std::string("\"0,0;1,1\",\"say \"\"no\"\"\",\"two\nlines\"\r\n"));
  }

  void whatIsWrittenReadsBack() {
    const std::vector<csv::Row> rows = {
        {"", "\"", "\"\"", ","}, {"\r\n", "a\"b", " c ", "\r"}, {"", "", "", ""}, {"x"}};
    QVERIFY(csv::parse(textOf(rows), "t.csv").value() == rows);
    QVERIFY(csv::parse("", "t.csv").value().empty());
  }

  void aLineFeedAloneEndsARowToo() {
    QVERIFY(csv::parse("a,b\nc,d", "t.csv").value() == (std::vector<csv::Row>{{"a", "b"}, {"c", "d"}}));
  }

  void aMisplacedQuoteIsToldWithItsLine_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("never closed") << QByteArray("a\n\"b") << QByteArray("line 2");
    QTest::newRow("in the middle") << QByteArray("a\nb\nc\"d") << QByteArray("line 3");
    QTest::newRow("something after it") << QByteArray("\"a\"b\n") << QByteArray("line 1");
    QTest::newRow("after a line break in a cell") << QByteArray("\"a\n\"\nb\"") << QByteArray("line 3");
  }
  void aMisplacedQuoteIsToldWithItsLine() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, line);
    const auto rows =
        csv::parse(std::string_view(text.data(), static_cast<std::size_t>(text.size())), "t.csv");
    QVERIFY(!rows);
    QCOMPARE(rows.error().code, ErrorCode::FileMalformed);
    QVERIFY(QByteArray::fromStdString(rows.error().message).startsWith("t.csv: "));
    QVERIFY(QByteArray::fromStdString(rows.error().message).contains(line));
  }
};

QTEST_APPLESS_MAIN(CsvTest)
#include "csv_test.moc"
