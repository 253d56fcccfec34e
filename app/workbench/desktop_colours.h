#pragma once

#include <QDBusConnection>
#include <QDBusVariant>
#include <QObject>

namespace graftsman {

/// Makes the program dark where the desktop wants dark windows and says so by the settings portal alone
/// (org.freedesktop.appearance, color-scheme), as GNOME does: from Qt 6.5 on Qt itself does that. A palette
/// that is dark already stays as it is. Follows what the person changes while the program runs.
class DesktopColours : public QObject {
  Q_OBJECT

 public:
  /// Asks at once, without waiting. Without a bus, or a portal on it, nothing happens.
  explicit DesktopColours(QDBusConnection bus = QDBusConnection::sessionBus(), QObject* parent = nullptr);

 private Q_SLOTS:
  void settingChanged(const QString& group, const QString& key, const QDBusVariant& value);

 private:
  void ask();
  void setDark(bool dark);

  QDBusConnection bus_;
  bool dark_ = false;  // made so by this
};

}  // namespace graftsman
