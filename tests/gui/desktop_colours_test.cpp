#include "app/workbench/desktop_colours.h"

#include <QApplication>
#include <QDBusPendingCallWatcher>
#include <QProcess>
#include <QSignalSpy>
#include <QtTest>

#include "tests/support/workbench.h"
#include "widgets/theme/theme.h"

using namespace graftsman;

namespace {

/// The part of the desktop that says which colours it wants.
class FakePortal : public QObject {
  Q_OBJECT
  Q_CLASSINFO("D-Bus Interface", "org.freedesktop.portal.Settings")

 public:
  uint scheme = 0;

  void set(uint value) {
    scheme = value;
    Q_EMIT SettingChanged("org.freedesktop.appearance", "color-scheme", QDBusVariant(value));
  }

 public Q_SLOTS:
  QDBusVariant Read(const QString& group, const QString& key) {
    const bool known = group == "org.freedesktop.appearance" && key == "color-scheme";
    return QDBusVariant(QVariant::fromValue(QDBusVariant(known ? scheme : 99U)));
  }

 Q_SIGNALS:
  void SettingChanged(const QString& group, const QString& key, const QDBusVariant& value);
};

bool isDark() {
  return themeFor(QApplication::palette()).dark;
}

}  // namespace

class DesktopColoursTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    daemon_.start("dbus-daemon", {"--session", "--nofork", "--print-address"});
    QVERIFY(daemon_.waitForReadyRead(kPatienceMs));
    address_ = QString::fromUtf8(daemon_.readLine()).trimmed();
    QDBusConnection desktop = QDBusConnection::connectToBus(address_, "desktop");
    QVERIFY(desktop.registerObject("/org/freedesktop/portal/desktop", &portal_,
                                   QDBusConnection::ExportAllSlots | QDBusConnection::ExportAllSignals));
    QVERIFY(desktop.registerService("org.freedesktop.portal.Desktop"));
    QVERIFY(!isDark());
  }
  void cleanup() { QApplication::setPalette(QPalette()); }
  void cleanupTestCase() {
    QDBusConnection::disconnectFromBus("desktop");
    QDBusConnection::disconnectFromBus("program");
    daemon_.terminate();
    daemon_.waitForFinished();
  }

  void theProgramIsAsDarkAsTheDesktopFromStartOn() {
    portal_.scheme = 1;
    const DesktopColours colours(QDBusConnection::connectToBus(address_, "program"));
    QTRY_VERIFY(isDark());
  }

  void itFollowsWhatThePersonChanges() {
    portal_.scheme = 0;
    const DesktopColours colours(QDBusConnection::connectToBus(address_, "program"));
    Workbench bench;
    portal_.set(1);
    QTRY_VERIFY(isDark());
    QTRY_VERIFY(bench.window->palette().color(QPalette::Window).lightness() < 128);
    portal_.set(2);  // light is wanted
    QTRY_VERIFY(!isDark());
    portal_.set(1);
    QTRY_VERIFY(isDark());
    portal_.set(0);  // either will do
    QTRY_VERIFY(!isDark());
  }

  void aDarkPaletteIsKept() {
    QPalette own(QColor("#201020"));
    QApplication::setPalette(own);
    QVERIFY(isDark());
    const DesktopColours colours(QDBusConnection::connectToBus(address_, "program"));
    portal_.set(1);
    portal_.set(2);
    // Signals come in order: once a later one is there, those before were looked at.
    QDBusMessage question =
        QDBusMessage::createMethodCall("org.freedesktop.portal.Desktop", "/org/freedesktop/portal/desktop",
                                       "org.freedesktop.portal.Settings", "Read");
    question << "org.freedesktop.appearance"
             << "color-scheme";
    auto bus = QDBusConnection::connectToBus(address_, "program");
    QDBusPendingCallWatcher answer(bus.asyncCall(question));
    QSignalSpy answered(&answer, &QDBusPendingCallWatcher::finished);
    QVERIFY(answered.wait(kPatienceMs));
    QCOMPARE(QApplication::palette().color(QPalette::Window), own.color(QPalette::Window));
  }

  void withoutABusNothingHappens() {
    const DesktopColours colours{QDBusConnection("there is none")};
    QVERIFY(!isDark());
  }

 private:
  QProcess daemon_;
  QString address_;
  FakePortal portal_;
};

QTEST_MAIN(DesktopColoursTest)

#include "desktop_colours_test.moc"
