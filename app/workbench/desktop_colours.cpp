#include "app/workbench/desktop_colours.h"

#include <QApplication>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QPalette>

#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

constexpr auto kPortal = "org.freedesktop.portal.Desktop";
constexpr auto kPortalPath = "/org/freedesktop/portal/desktop";
constexpr auto kPortalSettings = "org.freedesktop.portal.Settings";
constexpr auto kAppearance = "org.freedesktop.appearance";
constexpr auto kColourScheme = "color-scheme";

// Read() answers with a variant in a variant.
bool wantsDark(QVariant value) {
  while (value.userType() == qMetaTypeId<QDBusVariant>()) {
    value = value.value<QDBusVariant>().variant();
  }
  return value.toUInt() == 1;
}

// The colours of Qt's Fusion style on a dark desktop.
QPalette darkPalette() {
  const QColor window("#323232");
  const QColor text("#F0F0F0");
  const QColor faint("#8C8C8C");
  QPalette palette(QColor("#3C3C3C"), window);
  palette.setColor(QPalette::Base, QColor("#242424"));
  palette.setColor(QPalette::AlternateBase, QColor("#2B2B2B"));
  palette.setColor(QPalette::ToolTipBase, QColor("#3F3F3F"));
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    palette.setColor(role, text);
    palette.setColor(QPalette::Disabled, role, faint);
  }
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::PlaceholderText, QColor("#A0A0A0"));
  palette.setColor(QPalette::Highlight, QColor("#308CC6"));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor("#5A5A5A"));
  palette.setColor(QPalette::Link, QColor("#6FB1D3"));
  palette.setColor(QPalette::LinkVisited, QColor("#B59BD6"));
  return palette;
}

}  // namespace

DesktopColours::DesktopColours(QDBusConnection bus, QObject* parent) : QObject(parent), bus_(std::move(bus)) {
  if (bus_.isConnected()) {
    bus_.connect(kPortal, kPortalPath, kPortalSettings, "SettingChanged", this,
                 SLOT(settingChanged(QString, QString, QDBusVariant)));
    ask();
  }
}

void DesktopColours::ask() {
  QDBusMessage question = QDBusMessage::createMethodCall(kPortal, kPortalPath, kPortalSettings, "Read");
  question << QString(kAppearance) << QString(kColourScheme);
  auto* answer = new QDBusPendingCallWatcher(bus_.asyncCall(question), this);
  connect(answer, &QDBusPendingCallWatcher::finished, this, [this, answer] {
    const QDBusPendingReply<QDBusVariant> reply = *answer;
    if (reply.isValid()) {
      setDark(wantsDark(reply.value().variant()));
    }
    answer->deleteLater();
  });
}

void DesktopColours::settingChanged(const QString& group, const QString& key, const QDBusVariant& value) {
  if (group == kAppearance && key == kColourScheme) {
    setDark(wantsDark(value.variant()));
  }
}

void DesktopColours::setDark(bool dark) {
  if (dark && !dark_ && !themeFor(QApplication::palette()).dark) {
    dark_ = true;
    QApplication::setPalette(darkPalette());
  } else if (!dark && dark_) {
    dark_ = false;
    QApplication::setPalette(QPalette());
  }
}

}  // namespace graftsman
